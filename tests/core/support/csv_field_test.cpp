// SPDX-License-Identifier: Apache-2.0
#include "support/csv_field.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

TEST(CsvField, IsQuotedOnlyWhereItMust) {
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("1000 µs"), "1000 µs");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"a\""), "\"say \"\"a\"\"\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
}

}  // namespace
}  // namespace syncline
