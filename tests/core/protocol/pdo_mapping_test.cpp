// SPDX-License-Identifier: Apache-2.0
#include "protocol/pdo_mapping.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

// 0x607A:00 with 32 bits, as every tool writes it to 0x1600:01.
TEST(PdoMapping, HasItsObjectAboveItsSubIndexAndItsBits) {
  EXPECT_EQ((PdoMapping{0x607A, 0, 32}).word(), 0x607A0020U);
  EXPECT_EQ((PdoMapping{0x7000, 0x1F, 1}).word(), 0x70001F01U);
  EXPECT_EQ(PdoMapping::of(0x607A0020), (PdoMapping{0x607A, 0, 32}));
  EXPECT_EQ(PdoMapping::of((PdoMapping{0xFFFF, 0xFE, 0xFD}).word()), (PdoMapping{0xFFFF, 0xFE, 0xFD}));
}

}  // namespace
}  // namespace syncline
