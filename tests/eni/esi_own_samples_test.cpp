// SPDX-License-Identifier: Apache-2.0
// What our own ESI samples are written for is read out of them; the times are calculated by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/network_compare.h"
#include "compile/compile.h"
#include "config/module_slots.h"
#include "config/sync0_cycle.h"
#include "eni/esi/esi_reader.h"
#include "findings/error_text.h"
#include "protocol/sync_manager.h"
#include "recover/recover_project.h"
#include "support/byte_order.h"
#include "support/sample_folder.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

using ::testing::ElementsAre;

EsiFile sample_of(const std::string& name) {
  auto file = read_esi((test::own_samples("esi") / name).string());
  EXPECT_TRUE(file) << describe(file.error());
  return file ? std::move(*file) : EsiFile{};
}

DeviceDescription device_of(const std::string& name, std::size_t number = 0) {
  const auto file = sample_of(name);
  EXPECT_GT(file.devices.size(), number);
  return file.devices.size() > number ? file.devices[number] : DeviceDescription{};
}

struct Times {
  Nanoseconds cycle0, shift0, cycle1;
  bool operator==(const Times&) const = default;
};
Times times_of(const DcOpMode& mode, Nanoseconds bus_cycle) {
  const auto times = compiler::dc_times(mode, {}, bus_cycle);
  return {times.cycle_time0, times.shift_time, times.cycle_time1};
}

TEST(OwnEsiSamples, ExpressionsOfTheOperationModesGiveTheirTimes) {
  const auto modes = device_of("axis.xml").dc.value().op_modes;
  ASSERT_EQ(modes.size(), 5U);
  EXPECT_EQ(times_of(modes[0], kMillisecond), (Times{1'000'000, 0, 0}));
  // Factor -2: half the bus cycle; shift factor -4: a quarter of it.
  EXPECT_EQ(times_of(modes[1], kMillisecond), (Times{500'000, 250'000, 0}));
  EXPECT_EQ(times_of(modes[1], 4 * kMillisecond), (Times{2'000'000, 1'000'000, 0}));
  // SYNC1 every second SYNC0 and 50 us later: what stands in the register is its distance from SYNC0.
  EXPECT_EQ(times_of(modes[2], kMillisecond), (Times{1'000'000, 25'000, 1'050'000}));
  EXPECT_EQ(times_of(modes[3], kMillisecond), (Times{1'000'000, 0, 0}));
  const auto drive = device_of("sercos_axis.xml").dc.value().op_modes.at(0);
  EXPECT_EQ(times_of(drive, kMillisecond), (Times{250'000, 0, 30'000}));
  const auto oversampled = device_of("terminals.xml", 3).dc.value().op_modes.at(0);
  EXPECT_EQ(times_of(oversampled, 2 * kMillisecond).cycle0, 500'000);
}

TEST(OwnEsiSamples, PdosExcludeEachOther) {
  const auto axis = device_of("axis.xml");
  const auto& position = axis.rx_pdos.at(0);
  EXPECT_THAT(position.exclude, ElementsAre(0x1601, 0x1602));
  auto project = sample::project({axis});
  project.slaves[0].assigned_rx_pdos = {0x1600, 0x1601};
  const auto compiled = compile(project);
  ASSERT_TRUE(compiled);
  EXPECT_TRUE(std::ranges::any_of(compiled->findings, [](const Finding& f) { return f.severity == Severity::kError; }));
}

TEST(OwnEsiSamples, ModulesFitTheirSlots) {
  const auto station = device_of("station.xml");
  ASSERT_TRUE(station.slots);
  ASSERT_EQ(station.slots->slots.size(), 3U);
  EXPECT_EQ(station.slots->slots[0].default_module(), 0x110U);
  EXPECT_THAT(station.modules, ElementsAre(testing::Field(&ModuleDescription::ident, 0x110U),
                                           testing::Field(&ModuleDescription::ident, 0x120U),
                                           testing::Field(&ModuleDescription::ident, 0x130U)));
}

/// An export has their list (0xF030), whole or entry by entry; the project that is made of it has them at their places.
TEST(OwnEsiSamples, ModulesOfAnExportAreFoundAgain) {
  for (const bool whole : {true, false}) {
    auto station = device_of("station.xml");
    station.mailbox->coe->complete_access = whole;
    auto project = sample::project({station});
    auto& slave = project.slaves[0];
    for (const auto& [place, ident] : {std::pair(0, 0x120U), std::pair(2, 0x110U), std::pair(4, 0x130U)}) {
      ASSERT_TRUE(plug_module(slave, static_cast<std::uint16_t>(place), ident));
    }
    const auto compiled = compile(project);
    ASSERT_TRUE(compiled);
    const auto recovered = recover_project(compiled->config, [&](const Identity&) { return &station; });
    EXPECT_EQ(recovered.project.slaves[0].modules, slave.modules);
    EXPECT_EQ(recovered.project.slaves[0].device.source, station.source) << "its ESI was not taken";
    for (const auto& difference : recovered.differences) ADD_FAILURE() << describe(difference);
  }
}

/// The safe channel has a SyncManager and an FMMU of its own in each direction.
TEST(OwnEsiSamples, TwoSyncManagersOfOutputsAreBothMapped) {
  const auto compiled = compile(sample::project({device_of("safety.xml")}));
  ASSERT_TRUE(compiled);
  std::vector<std::uint16_t> lengths;
  for (const auto& cmd : compiled->config.slaves[0].init_cmds) {
    if (cmd.ado >= 0x0810 && cmd.ado <= 0x0828 && cmd.data.size() == SyncManager::kSize && cmd.data[6] != 0) {
      lengths.push_back(load_le<std::uint16_t>(std::span(cmd.data).subspan(2)));
    }
  }
  EXPECT_THAT(lengths, ElementsAre(4, 6, 6, 6));
  EXPECT_EQ(compiled->config.slaves[0].send->bit_length, 80U);
  EXPECT_EQ(compiled->config.slaves[0].receive->bit_length, 96U);
}

TEST(OwnEsiSamples, MailboxesSayTheirProtocols) {
  const auto balance = device_of("balance_latin1.xml").mailbox.value();
  EXPECT_TRUE(balance.aoe && balance.eoe && balance.coe && balance.foe && balance.voe && !balance.soe);
  EXPECT_TRUE(balance.eoe_options.time_stamp && balance.coe->diag_history);
  const auto drive = device_of("sercos_axis.xml").mailbox.value();
  EXPECT_TRUE(drive.soe && !drive.coe);
  EXPECT_EQ(drive.soe_options.channel_count, 2);
  ASSERT_EQ(drive.soe_options.init_commands.size(), 2U);
  EXPECT_EQ(drive.soe_options.init_commands[1].drive, 1);
}

TEST(OwnEsiSamples, CodePagesBecomeUtf8) {
  const auto balance = sample_of("balance_latin1.xml");
  EXPECT_EQ(balance.devices.at(0).vendor_name,
            "G\xC3\xBCnther Pr\xC3\xBC"
            "fger\xC3\xA4te");
  EXPECT_TRUE(balance.warnings.empty());
  const auto servo = sample_of("servo_gb2312.xml");
  EXPECT_EQ(servo.devices.at(0).vendor_name, "\xE9\x9D\x92\xE7\x9F\xB3\xE4\xBC\xBA\xE6\x9C\x8D");
  EXPECT_TRUE(servo.warnings.empty());
}

TEST(OwnEsiSamples, OldWaysAreForgivenWithWarnings) {
  const auto file = sample_of("old_ways.xml");
  ASSERT_EQ(file.devices.size(), 2U) << "the third has two PDOs of one index";
  EXPECT_EQ(file.devices[0].identity.product_code, 0x77U);
  std::vector<std::string> names;
  for (const auto& pdo : file.devices[0].tx_pdos) names.push_back(pdo.name);
  EXPECT_THAT(names, ElementsAre("Channel #1", "Channel #2", "Channel #3", "Channel #4"));
  EXPECT_EQ(file.devices[0].tx_pdos[3].entries.at(0).index, 0x6030);
  EXPECT_GE(file.warnings.size(), 3U);
}

}  // namespace
}  // namespace syncline::eni
