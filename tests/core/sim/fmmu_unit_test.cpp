// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/fmmu_unit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "sim/dc/dc_unit.h"
#include "sim/esc/passing_frame.h"
#include "sim/esc/sync_managers.h"
#include "sim/registers/esc_memory.h"
#include "sim/registers/write_protection.h"

namespace syncline::sim {
namespace {

constexpr std::uint16_t kOutputs = 0x1100, kInputs = 0x1180, kSize = 4;
constexpr std::uint32_t kLogical = 0x0001'0000;

/// Outputs and inputs of four bytes behind two SyncManagers, with an FMMU each.
class Fmmus : public testing::Test {
 protected:
  Fmmus() {
    managers_.implement_registers();
    fmmus_.implement_registers();
    set_manager(0, {kOutputs, kSize, 0x64, 0, 1, 0});
    set_manager(1, {kInputs, kSize, 0x20, 0, 1, 0});
    set_fmmu(0, {kLogical, kSize, 0, 7, kOutputs, 0, false, true, true});
    set_fmmu(1, {kLogical + kSize, kSize, 0, 7, kInputs, 0, true, false, true});
    reload();
  }
  void set_manager(unsigned number, const SyncManager& manager) {
    std::ranges::copy(manager.encode(), memory_.at(reg::sync_manager(number), SyncManager::kSize).begin());
  }
  void set_fmmu(unsigned number, const Fmmu& fmmu) {
    std::ranges::copy(fmmu.encode(), memory_.at(reg::fmmu(number), Fmmu::kSize).begin());
  }
  void reload() {
    managers_.reload();
    fmmus_.reload();
  }
  bool write(std::uint32_t address, std::vector<std::uint8_t> bytes) {
    PassingDatagram datagram;
    datagram.address = address;
    datagram.data = bytes;
    return fmmus_.write(datagram, 0);
  }
  std::vector<std::uint8_t> read(std::uint32_t address, std::size_t length, bool expected = true) {
    std::vector<std::uint8_t> bytes(length, 0xEE);
    PassingDatagram datagram;
    datagram.address = address;
    datagram.data = bytes;
    EXPECT_EQ(fmmus_.read(datagram, 0), expected);
    return bytes;
  }
  [[nodiscard]] std::vector<std::uint8_t> memory(std::uint16_t address, std::size_t length) const {
    const auto bytes = memory_.at(address, length);
    return {bytes.begin(), bytes.end()};
  }

  using Bytes = std::vector<std::uint8_t>;
  EscMemory memory_{0x1000};
  SyncManagers managers_{memory_, 4};
  WriteProtection protection_{memory_};
  DcUnit clock_{{}, {}, 0, 1, memory_};
  FmmuUnit fmmus_{memory_, managers_, protection_, clock_, 3};
};

TEST_F(Fmmus, AWholeBufferIsOneTransfer) {
  ASSERT_EQ(fmmus_.writing().size(), 1U);
  EXPECT_EQ(fmmus_.writing()[0].whole_buffer, 0U);
  EXPECT_EQ(fmmus_.reading()[0].whole_buffer, 1U);
  EXPECT_TRUE(write(kLogical, {1, 2, 3, 4}));
  EXPECT_EQ(memory(kOutputs, 4), (Bytes{1, 2, 3, 4}));
  EXPECT_EQ(managers_.written(), 0b01U);
  const std::array<std::uint8_t, 4> inputs{5, 6, 7, 8};
  ASSERT_TRUE(managers_.put(1, inputs));
  EXPECT_EQ(read(kLogical, 10), (Bytes{0xEE, 0xEE, 0xEE, 0xEE, 5, 6, 7, 8, 0xEE, 0xEE}));
  EXPECT_EQ(managers_.read(), 0b10U);
}

TEST_F(Fmmus, APartOfABufferIsNoTransferBeforeItsEnd) {
  EXPECT_TRUE(write(kLogical, {1, 2}));
  EXPECT_EQ(managers_.written(), 0U);
  EXPECT_TRUE(write(kLogical + 2, {3, 4}));
  EXPECT_EQ(managers_.written(), 0b01U);
  EXPECT_EQ(memory(kOutputs, 4), (Bytes{1, 2, 3, 4}));
}

TEST_F(Fmmus, NothingIsMappedBesideThem) {
  EXPECT_FALSE(write(kLogical - 4, {1, 2, 3, 4}));
  EXPECT_FALSE(write(kLogical + kSize, {1, 2, 3, 4})) << "which is read";
  EXPECT_EQ(read(kLogical, kSize, false), Bytes(kSize, 0xEE));
}

TEST_F(Fmmus, BitsGoToTheirPlacesAndNoOthers) {
  set_fmmu(2, {kLogical + 0x100, 1, 2, 4, 0x0F80, 5, true, true, true});  // three bits of the user RAM
  reload();
  memory_.set<std::uint8_t>(0x0F80, 0x1F);
  EXPECT_FALSE(fmmus_.writing()[1].whole_buffer);
  EXPECT_TRUE(write(kLogical + 0x100, {0b0001'0111}));
  EXPECT_EQ(memory_.u8(0x0F80), 0b1011'1111);
  EXPECT_EQ(read(kLogical + 0x100, 1), Bytes{static_cast<std::uint8_t>((0xEE & ~0b0001'1100) | 0b0001'0100)});
}

TEST_F(Fmmus, WhatIsOffOrEmptyMapsNothing) {
  set_fmmu(0, {kLogical, kSize, 0, 7, kOutputs, 0, false, true, false});
  set_fmmu(1, {kLogical + kSize, 0, 0, 7, kInputs, 0, true, false, true});
  reload();
  EXPECT_TRUE(fmmus_.writing().empty());
  EXPECT_TRUE(fmmus_.reading().empty());
}

TEST_F(Fmmus, ProtectedMemoryIsNotWritten) {
  memory_.set<std::uint8_t>(0x0031, 1);
  EXPECT_FALSE(write(kLogical, {1, 2, 3, 4}));
  EXPECT_EQ(memory(kOutputs, 4), Bytes(4, 0));
  EXPECT_EQ(managers_.written(), 0U);
}

TEST_F(Fmmus, AnFmmuOfTwoBuffersMapsNoneAsAWhole) {
  set_manager(1, {kOutputs + kSize, kSize, 0x64, 0, 1, 0});
  set_fmmu(0, {kLogical, 2 * kSize, 0, 7, kOutputs, 0, false, true, true});
  reload();
  EXPECT_FALSE(fmmus_.writing()[0].whole_buffer);
}

TEST_F(Fmmus, HaveAsManyRegistersAsThereAre) {
  EXPECT_EQ(memory_.rights(0x062F), EscMemory::kReadWrite);
  EXPECT_EQ(memory_.rights(0x0630), 0);
}

}  // namespace
}  // namespace syncline::sim
