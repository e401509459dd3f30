// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "byte_helpers.h"
#include "protocol/fmmu.h"
#include "protocol/sync_manager.h"

namespace syncline {
namespace {

using test::Bytes;
using test::from_hex;

template <class Array>
Bytes bytes_of(const Array& array) {
  return {array.begin(), array.end()};
}

TEST(Fmmu, ImageByHand) {
  Fmmu fmmu;
  fmmu.logical_start = 0x01000002;
  fmmu.length = 3;
  fmmu.logical_start_bit = 4;
  fmmu.logical_stop_bit = 5;
  fmmu.physical_start = 0x1100;
  fmmu.physical_start_bit = 2;
  fmmu.write = true;
  fmmu.active = true;
  EXPECT_EQ(bytes_of(fmmu.encode()), from_hex("02000001 0300 04 05 0011 02 02 01 000000"));
  EXPECT_EQ(fmmu.bit_length(), 18U);
}

TEST(Fmmu, BitLength) {
  Fmmu fmmu;
  EXPECT_EQ(fmmu.bit_length(), 0U);
  fmmu.length = 1;
  EXPECT_EQ(fmmu.bit_length(), 8U);
  fmmu.logical_start_bit = fmmu.logical_stop_bit = 3;
  EXPECT_EQ(fmmu.bit_length(), 1U);
  fmmu.logical_stop_bit = 1;  // ends before it begins
  EXPECT_EQ(fmmu.bit_length(), 0U);
  fmmu.length = 2;
  EXPECT_EQ(fmmu.bit_length(), 7U);
}

TEST(Fmmu, RoundTrip) {
  EXPECT_TRUE(
      rc::check([](std::uint32_t logical, std::uint16_t length, std::uint16_t physical, bool r, bool w, bool a) {
        const auto bit = [] { return static_cast<std::uint8_t>(*rc::gen::inRange(0, 8)); };
        const Fmmu fmmu{logical, length, bit(), bit(), physical, bit(), r, w, a};
        RC_ASSERT(Fmmu::decode(fmmu.encode()) == fmmu);
      }));
}

TEST(Fmmu, ReservedBitsAreIgnored) {
  EXPECT_TRUE(rc::check([](const std::array<std::uint8_t, Fmmu::kSize>& bytes) {
    const auto fmmu = Fmmu::decode(bytes);
    RC_ASSERT(Fmmu::decode(fmmu.encode()) == fmmu);
    RC_ASSERT(fmmu.bit_length() <= 8U * fmmu.length);
  }));
}

TEST(SyncManager, ImageByHand) {
  const SyncManager mailbox{0x1000, 0x0080, 0x26, 0x00, 0x01, 0x00};
  EXPECT_EQ(bytes_of(mailbox.encode()), from_hex("0010 8000 26 00 01 00"));
  EXPECT_TRUE(mailbox.is_mailbox());
  EXPECT_TRUE(mailbox.ecat_writes());
  EXPECT_TRUE(mailbox.enabled());
  const SyncManager inputs{0x1400, 6, 0x20, 0, 0, 0};
  EXPECT_FALSE(inputs.is_mailbox());
  EXPECT_FALSE(inputs.ecat_writes());
  EXPECT_FALSE(inputs.enabled());
}

TEST(SyncManager, RoundTrip) {
  EXPECT_TRUE(rc::check([](const std::array<std::uint8_t, SyncManager::kSize>& bytes) {
    RC_ASSERT(SyncManager::decode(bytes).encode() == bytes);
  }));
}

}  // namespace
}  // namespace syncline
