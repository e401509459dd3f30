// SPDX-License-Identifier: Apache-2.0
#include "support/byte_order.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>

namespace syncline {
namespace {

TEST(ByteOrder, LittleEndianByHand) {
  EXPECT_EQ(le_bytes(std::uint32_t{0x12345678}), (std::vector<std::uint8_t>{0x78, 0x56, 0x34, 0x12}));
  const std::array<std::uint8_t, 8> bytes{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(load_le<std::uint16_t>(bytes), 0x0201U);
  EXPECT_EQ(load_le<std::uint64_t>(bytes), 0x0807060504030201U);
}

TEST(ByteOrder, WhatIsWrittenIsRead) {
  EXPECT_TRUE(rc::check([](std::uint8_t a, std::uint16_t b, std::uint32_t c, std::uint64_t d) {
    std::vector<std::uint8_t> bytes;
    ByteWriter(bytes).u8(a).u16(b).u32(c).u64(d);
    ByteReader reader(bytes);
    RC_ASSERT(reader.u8() == a);
    RC_ASSERT(reader.u16() == b);
    RC_ASSERT(reader.u32() == c);
    RC_ASSERT(reader.u64() == d);
    RC_ASSERT(reader.ok());
    RC_ASSERT(reader.remaining() == 0U);
  }));
}

TEST(ByteReader, FailsForGoodBeyondTheEnd) {
  const std::array<std::uint8_t, 3> bytes{1, 2, 3};
  ByteReader reader(bytes);
  EXPECT_EQ(reader.u32(), 0U);
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.u8(), 0U);  // although a byte would be there
  EXPECT_EQ(reader.position(), 0U);
}

TEST(ByteReader, HugeCountsDoNotWrapRound) {
  const std::array<std::uint8_t, 3> bytes{1, 2, 3};
  ByteReader reader(bytes);
  reader.skip(1);
  EXPECT_TRUE(reader.take(SIZE_MAX).empty());
  EXPECT_FALSE(reader.ok());
}

}  // namespace
}  // namespace syncline
