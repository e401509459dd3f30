// SPDX-License-Identifier: Apache-2.0
#include "support/bits.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

TEST(LowBits, AreAsManyAsAsked) {
  EXPECT_EQ(low_bits(0), 0U);
  EXPECT_EQ(low_bits(1), 1U);
  EXPECT_EQ(low_bits(12), 0xFFFU);
  EXPECT_EQ(low_bits(63), 0x7FFF'FFFF'FFFF'FFFFU);
  EXPECT_EQ(low_bits(64), 0xFFFF'FFFF'FFFF'FFFFU) << "no shift by all the bits that there are";
  EXPECT_EQ(low_bits(65), 0xFFFF'FFFF'FFFF'FFFFU);
}

}  // namespace
}  // namespace syncline
