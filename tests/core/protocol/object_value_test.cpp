// SPDX-License-Identifier: Apache-2.0
#include "protocol/object_value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace syncline {
namespace {

using testing::ElementsAre;

TEST(ObjectValue, NumbersKeepTheirRange) {
  EXPECT_THAT(value_bytes(0x0003, "-2").value(), ElementsAre(0xFE, 0xFF));
  EXPECT_THAT(value_bytes(0x0003, "0xFFFE").value(), ElementsAre(0xFE, 0xFF));
  EXPECT_THAT(value_bytes(0x0003, "-32768").value(), ElementsAre(0x00, 0x80));
  EXPECT_FALSE(value_bytes(0x0003, "32768"));
  EXPECT_FALSE(value_bytes(0x0003, "-32769"));
  EXPECT_FALSE(value_bytes(0x0006, "-1"));
  EXPECT_FALSE(value_bytes(0x0006, "12x"));
  EXPECT_FALSE(value_bytes(0x0005, "256"));
  EXPECT_EQ(value_text(0x001B, value_bytes(0x001B, "18446744073709551615").value()), "18446744073709551615");
  EXPECT_EQ(value_text(0x0015, value_bytes(0x0015, "-9223372036854775808").value()), "-9223372036854775808");
  EXPECT_EQ(value_text(0x0008, value_bytes(0x0008, "1.5").value()), "1.5");
  EXPECT_THAT(value_bytes(kBytesType, "0x12 ab").value(), ElementsAre(0x12, 0xAB));
  EXPECT_FALSE(value_bytes(kBytesType, "123"));
  EXPECT_EQ(value_text(0x0006, std::vector<std::uint8_t>{1, 2, 3}), "01 02 03");  // is no UINT
}

TEST(ObjectValue, ObjectsAreNamedInHexadecimal) {
  EXPECT_EQ(object_name("0x1018:0A").value().sub_index, 10);
  EXPECT_EQ(object_name("1018").value().index, 0x1018);
  EXPECT_FALSE(object_name("0x10180:1"));
  EXPECT_FALSE(object_name("1018:"));
  EXPECT_FALSE(object_name("name"));
}

}  // namespace
}  // namespace syncline
