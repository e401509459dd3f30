// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/sii.h"
#include "sim/device/sii_from_device.h"
#include "tests/core/sim/sim_probe.h"

/// Registers 0x0500 to 0x050F (ESC data sheet II, 3.9).
namespace syncline::test {
namespace {

constexpr std::uint16_t kRead = 0x0100, kWrite = 0x0201, kReload = 0x0400;
constexpr std::uint16_t kChecksumError = 0x0800, kNotLoaded = 0x1000, kCommandError = 0x2000,
                        kWriteEnableError = 0x4000, kBusy = 0x8000;

SimConfig one_terminal(SimSiiConfig sii = {}) {
  auto slave = sim_slave("SL-1100");
  slave.alias = 0x0123;
  slave.sii = sii;
  return line({slave});
}

class SimSiiAccess {
 public:
  explicit SimSiiAccess(const SimConfig& config) : probe(config) {}
  void command(std::uint16_t control, std::uint32_t word) {
    std::vector<std::uint8_t> bytes;
    ByteWriter(bytes).u16(control).u32(word);
    probe.write(0, reg::kSiiControl, bytes);
  }
  void write_word(std::uint32_t word, std::uint16_t value, std::uint16_t control = kWrite) {
    probe.write(0, reg::kSiiData, le_bytes(value));
    command(control, word);
  }
  std::uint16_t status() { return probe.read(0, reg::kSiiControl, 2).value<std::uint16_t>(); }
  std::uint64_t data() { return probe.read(0, reg::kSiiData, 8).value<std::uint64_t>(); }
  std::uint16_t word(std::uint32_t number) {
    command(kRead, number);
    return static_cast<std::uint16_t>(data());
  }
  std::uint16_t alias() { return probe.read(0, reg::kStationAlias, 2).value<std::uint16_t>(); }
  SimProbe probe;
};

TEST(SimSiiInterface, IsBusyForAsLongAsAReadTakes) {
  SimSiiAccess sii(one_terminal({kMillisecond, 4 * kMillisecond, true}));
  sii.command(kRead, 4);
  EXPECT_EQ(sii.status() & kBusy, kBusy);
  EXPECT_EQ(sii.data(), 0U) << "nothing there yet";
  sii.command(kRead, 8);  // while busy: not accepted
  sii.probe.pass(kMillisecond);
  EXPECT_EQ(sii.status() & (kBusy | kCommandError), 0);
  EXPECT_EQ(sii.data() & 0xFFFF, 0x0123U) << "the answer is that of the first command";
  sii.write_word(4, 0x0456);
  sii.probe.pass(3 * kMillisecond);
  EXPECT_EQ(sii.status() & kBusy, kBusy) << "writing takes longer";
  sii.probe.pass(kMillisecond);
  EXPECT_EQ(sii.status() & kBusy, 0);
}

TEST(SimSiiInterface, ReadsFourOrEightBytes) {
  for (const bool eight : {true, false}) {
    SimSiiAccess sii(one_terminal({0, 0, eight}));
    EXPECT_EQ((sii.status() & 0x0040) != 0, eight);
    sii.command(kRead, 8);
    const auto data = sii.data();
    EXPECT_NE(data & 0xFFFF'FFFFU, 0U);
    EXPECT_EQ((data >> 32) != 0, eight);
  }
}

TEST(SimSiiInterface, OnlyTheOwnerGivesCommands) {
  SimSiiAccess sii(one_terminal());
  sii.probe.write(0, reg::kSiiConfiguration, {0x01});
  sii.command(kRead, 4);
  EXPECT_EQ(sii.data(), 0U) << "offered to the PDI";
  EXPECT_EQ(sii.probe.write(0, reg::kSiiPdiAccess, {0x01}).wkc, 0) << "the PDI's register";
  sii.probe.write(0, reg::kSiiConfiguration, {0x02});
  sii.probe.write(0, reg::kSiiConfiguration, {0x00});
  EXPECT_EQ(sii.word(4), 0x0123);
}

TEST(SimSiiInterface, WriteEnableHoldsForOneCommandOfItsOwnFrame) {
  SimSiiAccess sii(one_terminal());
  sii.write_word(4, 0x0456, 0x0200);
  EXPECT_EQ(sii.status() & kWriteEnableError, kWriteEnableError);
  EXPECT_EQ(sii.word(4), 0x0123);
  EXPECT_EQ(sii.status() & kWriteEnableError, 0) << "the next command clears it";
  sii.probe.write(0, reg::kSiiControl, {0x01});
  sii.probe.write(0, reg::kSiiControl + 1, {0x02});
  EXPECT_EQ(sii.status() & kWriteEnableError, kWriteEnableError) << "another frame";
  sii.write_word(4, 0x0456);
  EXPECT_EQ(sii.status() & (kWriteEnableError | kCommandError), 0);
  EXPECT_EQ(sii.word(4), 0x0456);
  sii.write_word(4, 0x0789, 0x0200);
  EXPECT_EQ(sii.word(4), 0x0456) << "each needs its own";
}

TEST(SimSiiInterface, TheLastWordCanBeWrittenAndNoneBehindIt) {
  const auto config = one_terminal();
  SimSiiAccess sii(config);
  const auto words = static_cast<std::uint32_t>(sim::factory_sii(config.slaves[0]).size() / 2);
  sii.write_word(words - 1, 0x5A5A);
  EXPECT_EQ(sii.status() & kCommandError, 0);
  EXPECT_EQ(sii.word(words - 1), 0x5A5A);
  sii.write_word(words, 0x5A5A);
  EXPECT_EQ(sii.status() & kCommandError, kCommandError);
  EXPECT_EQ(sii.word(words), 0xFFFF);
}

TEST(SimSiiInterface, AnUnknownCommandIsAnError) {
  SimSiiAccess sii(one_terminal());
  sii.command(0x0300, 4);
  EXPECT_EQ(sii.status() & kCommandError, kCommandError);
  sii.command(0, 0);
  EXPECT_EQ(sii.status() & kCommandError, 0);
}

TEST(SimSiiInterface, TheAliasIsTakenOverAtReloadAndAtPowerOn) {
  auto config = one_terminal();
  config.faults.push_back({FaultKind::kSlaveOff, 0, kSecond, kSecond + kMillisecond});
  SimSiiAccess sii(config);
  const auto write_alias = [&sii](std::uint16_t alias) {
    std::vector<std::uint8_t> head;
    for (std::uint32_t word = 0; word < 7; ++word) ByteWriter(head).u16(word == 4 ? alias : sii.word(word));
    sii.write_word(4, alias);
    sii.write_word(7, sii::checksum(head));
  };
  write_alias(0x0456);
  EXPECT_EQ(sii.alias(), 0x0123);
  sii.command(kReload, 0);
  EXPECT_EQ(sii.alias(), 0x0456);
  write_alias(0x0789);
  sii.probe.pass(2 * kSecond);
  EXPECT_EQ(sii.alias(), 0x0789) << "the EEPROM outlives the power";
}

TEST(SimSiiInterface, AWrongChecksumIsReportedAndNothingIsLoaded) {
  SimSiiAccess sii(one_terminal());
  sii.write_word(4, 0x0456);  // without its checksum
  EXPECT_EQ(sii.status() & (kChecksumError | kNotLoaded), 0) << "noticed when it is loaded";
  sii.command(kReload, 0);
  EXPECT_EQ(sii.status() & (kChecksumError | kNotLoaded), kChecksumError | kNotLoaded);
  EXPECT_EQ(sii.alias(), 0x0123);
}

}  // namespace
}  // namespace syncline::test
