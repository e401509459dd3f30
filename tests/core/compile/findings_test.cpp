// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "compile/compile.h"
#include "config/frame_time.h"
#include "settings/settings_keys.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// "error slave.3.pdo.rx" for each finding; keys must be settings of the project.
std::vector<std::string> found(const Project& project) {
  const auto result = compile(project).value();
  std::vector<std::string> out;
  for (const auto& finding : result.findings) {
    const char* severities[] = {"info", "warning", "error"};
    out.push_back(std::string(severities[static_cast<int>(finding.severity)]) + " " + finding.place.key);
    EXPECT_FALSE(describe(finding).empty());
    EXPECT_EQ(describe(finding).find('{'), std::string::npos) << describe(finding);
    if (!finding.place.key.empty()) {
      EXPECT_TRUE(get_setting(project, finding.place.key)) << finding.place.key;
    }
  }
  return out;
}

TEST(Findings, AGoodProjectHasNone) { EXPECT_THAT(found(sample::small_machine()), IsEmpty()); }

TEST(Findings, PdoAssignment) {
  Project project = sample::small_machine();
  auto& servo = project.slaves[3];
  servo.assigned_rx_pdos = {0x1600, 0x1600, 0x1699};
  EXPECT_THAT(found(project), ElementsAre("error slave.3.pdo.rx", "error slave.3.pdo.rx"));
  servo.assigned_rx_pdos = {0x1600, 0x1601};
  servo.device.rx_pdos[1].exclude = {0x1600};
  EXPECT_THAT(found(project), ElementsAre("error slave.3.pdo.rx"));
  servo.assigned_rx_pdos = {};
  servo.device.rx_pdos[0].mandatory = true;
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.pdo.rx"));
}

TEST(Findings, AssignmentOfADeviceThatCannotBeTold) {
  Project project = sample::small_machine();
  project.slaves[1].assigned_tx_pdos = {0x1A00};
  EXPECT_THAT(found(project), ElementsAre("warning slave.1.pdo.tx"));
}

TEST(Findings, HotConnectGroups) {
  Project project = sample::small_machine();
  project.slaves[3].hot_connect = "Trolley";
  EXPECT_THAT(found(project), ElementsAre("error slave.3.alias"));
  project.slaves[3].alias = 5;
  EXPECT_THAT(found(project), IsEmpty());
  project.slaves[0].hot_connect = "All";
  project.slaves[0].alias = 6;
  EXPECT_THAT(found(project), ElementsAre("error slave.0.hot_connect"));
}

TEST(Findings, SyncManagerSizes) {
  Project project = sample::small_machine();
  project.slaves[3].device.sync_managers[2].max_size = 5;
  project.slaves[3].device.sync_managers[3].min_size = 9;
  EXPECT_THAT(found(project), ElementsAre("error slave.3.pdo.rx", "error slave.3.pdo.tx"));
}

TEST(Findings, FmmusAndFrameSize) {
  Project project = sample::small_machine();
  project.slaves[3].device.fmmus = {FmmuUse::kOutputs};
  EXPECT_THAT(found(project), ElementsAre("error slave.3.pdo.rx"));
  project = sample::small_machine();
  project.slaves[3].device.sync_managers[3].max_size.reset();
  project.slaves[3].device.tx_pdos[0].entries = {{0x3000, 1, 1500 * 8, "Block", "ARRAY"}};
  EXPECT_THAT(found(project), ElementsAre("error slave.3.pdo.rx"));
}

TEST(Findings, ChangedMappings) {
  Project project = sample::small_machine();
  project.slaves[3].changed_pdos = {project.slaves[3].device.rx_pdos[0]};
  EXPECT_THAT(found(project), ElementsAre("error slave.3.pdo.map.0x1600"));
}

TEST(Findings, Mailbox) {
  Project project = sample::small_machine();
  project.slaves[3].device.sync_managers[1].default_size.reset();
  EXPECT_THAT(found(project), ElementsAre("error "));
}

TEST(Findings, OperationMode) {
  Project project = sample::small_machine();
  project.slaves[3].dc.op_mode = "Free";
  EXPECT_THAT(found(project), ElementsAre("error slave.3.dc.op_mode"));
  project.slaves[3].dc.op_mode = "DC Sync";
  project.slaves[3].dc.sync0.cycle_factor = -3;
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.dc.sync0.factor", "warning slave.3.dc.sync0.cycle_us"));
  project.slaves[3].dc.sync0.cycle_factor = 0;
  EXPECT_THAT(found(project), ElementsAre("error slave.3.dc.sync0.cycle_us"));
  project.slaves[3].dc.sync0.cycle_factor = 1;
  project.slaves[3].device.dc->op_modes[0].assign_activate = 0x0700;
  project.slaves[3].dc.sync1.shift = -1;
  EXPECT_THAT(found(project), ElementsAre("error slave.3.dc.sync1.shift_us"));
}

TEST(Findings, TimesOfSyncSignalsThatNobodyHolds) {
  Project project = sample::small_machine();
  auto& dc = project.slaves[3].dc;
  dc.sync0.shift = 999'999;
  EXPECT_THAT(found(project), IsEmpty());
  dc.sync0.shift = kMillisecond;
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.dc.sync0.shift_us"));
  dc.sync0.shift = -kMillisecond;
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.dc.sync0.shift_us"));
  dc.sync0.shift = 2'147'484 * kMicrosecond;
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.dc.sync0.shift_us", "error slave.3.dc.sync0.shift_us"));
  dc.sync0.shift.reset();
  project.master.cycle_time = 10 * kMillisecond;
  dc.sync0.cycle_factor = 214;
  EXPECT_THAT(found(project), IsEmpty());
  dc.sync0.cycle_factor = 215;  // 2.15 s
  EXPECT_THAT(found(project), ElementsAre("error slave.3.dc.sync0.cycle_us"));
}

TEST(Findings, TimesOfSyncSignalsThatDoNotCome) {
  Project project = sample::small_machine();
  auto& slave = project.slaves[3];
  slave.dc.sync1.shift = 100;
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.dc.sync1.shift_us"));
  slave.device.dc->op_modes[0].assign_activate = 0x0700;
  EXPECT_THAT(found(project), IsEmpty());
  slave.dc.sync0.user_cycle = kMillisecond;
  slave.dc.op_mode.clear();
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.dc.sync0.cycle_us", "warning slave.3.dc.sync1.shift_us"));
}

TEST(Findings, OutputsThatNothingTakesAwayWhenFramesStop) {
  Project project = sample::small_machine();
  auto& servo = project.slaves[3];
  servo.watchdog.process_data = 0;
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.watchdog.process_data"));
  servo.watchdog.process_data.reset();
  servo.watchdog.outputs = false;
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.watchdog.outputs"));
  servo.watchdog.outputs = true;
  EXPECT_THAT(found(project), IsEmpty());
  project.slaves[1].watchdog.process_data = 0;  // has inputs only
  EXPECT_THAT(found(project), IsEmpty());
}

TEST(Findings, ADriveThatIsToldNothing) {
  Project project = sample::small_machine();
  project.slaves[3].assigned_rx_pdos.clear();
  EXPECT_THAT(found(project), ElementsAre("info slave.3.pdo.rx"));
}

TEST(Findings, ASerialNumberThatNobodyKnowsIsNotComparedSilently) {
  Project project = sample::small_machine();
  project.slaves[3].check.serial = true;
  EXPECT_THAT(found(project), ElementsAre("warning slave.3.check.serial"));
  project.slaves[3].device.identity.serial_no = 4711;
  EXPECT_THAT(found(project), IsEmpty());
}

TEST(Findings, AliasesThatTwoSlavesAreKnownBy) {
  Project project = sample::small_machine();
  project.slaves[2].alias = project.slaves[3].alias = 7;
  EXPECT_THAT(found(project), IsEmpty()) << "nobody asks for them";
  project.slaves[2].check.alias = project.slaves[3].check.alias = true;
  EXPECT_THAT(found(project), ElementsAre("error slave.3.alias"));
  project.slaves[3].check.alias = false;
  project.slaves[3].optional = true;
  EXPECT_THAT(found(project), ElementsAre("error slave.3.alias"));
  project.slaves[3].check.device_id = 3;
  EXPECT_THAT(found(project), testing::Not(testing::Contains("error slave.3.alias")));
  project.slaves[2].alias = project.slaves[3].alias = 0;
  project.slaves[3] = sample::small_machine().slaves[3];
  project.slaves[3].check.alias = true;
  EXPECT_THAT(found(project), IsEmpty()) << "0 says that there is none";
}

TEST(Findings, Topology) {
  Project project = sample::small_machine();
  project.slaves[1].previous.reset();
  project.slaves[2].previous = PreviousPort{2, 1};
  project.slaves[3].previous = PreviousPort{0, 0};
  EXPECT_THAT(found(project),
              ElementsAre("error slave.2.previous", "error slave.3.previous", "warning slave.1.previous"));
}

TEST(Findings, ASlaveWithSwappedCablesStandsBehindWhatHangsAtIt) {
  Project project = sample::small_machine();
  project.slaves[1].previous = PreviousPort{2, 0};
  project.slaves[2].previous = PreviousPort{0, 1};
  EXPECT_THAT(found(project), ElementsAre("warning slave.2.previous"));
  project.slaves[2].previous = PreviousPort{1, 1};
  EXPECT_THAT(found(project), testing::Contains("error slave.1.previous")) << "in a circle";
}

TEST(Findings, StationAddresses) {
  Project project = sample::small_machine();
  project.slaves[1].station_address = 0;
  project.slaves[2].station_address = 1004;
  EXPECT_THAT(found(project), ElementsAre("error slave.1.station_address", "error slave.3.station_address"));
}

TEST(Findings, CycleTime) {
  Project project = sample::small_machine();
  project.master.cycle_time = 62'500;
  EXPECT_THAT(found(project), ElementsAre("warning master.cycle_time_us", "warning slave.3.startup.0"));
  project = sample::project(std::vector<DeviceDescription>(20, sample::servo()));
  project.master.cycle_time = 32 * kMicrosecond;
  for (auto& slave : project.slaves) {
    slave.startup.clear();
    slave.device.sync_managers[3].max_size.reset();
    slave.device.tx_pdos[0].entries = {{0x3000, 1, 800, "Block", "ARRAY"}};
  }
  EXPECT_THAT(found(project), ElementsAre("error master.cycle_time_us"));
  project.master.cycle_time = 200 * kMicrosecond;
  EXPECT_THAT(found(project), ElementsAre("warning master.cycle_time_us"));
}

TEST(Findings, ReferenceClock) {
  Project project = sample::small_machine();
  project.master.dc.reference_clock = 1;
  EXPECT_THAT(found(project), ElementsAre("error master.dc.reference_clock"));
  EXPECT_EQ(compile(project)->config.reference_clock(), 3);
  project.master.dc.reference_clock = 9;
  EXPECT_THAT(found(project), ElementsAre("error master.dc.reference_clock"));
  project = sample::project({sample::servo(), sample::servo()});
  project.master.dc.reference_clock = 1;
  EXPECT_THAT(found(project), ElementsAre("warning master.dc.reference_clock"));
  EXPECT_EQ(compile(project)->config.reference_clock(), 1);
}

TEST(Findings, DcSettingsThatDoNothingOrHarm) {
  Project project = sample::small_machine();
  project.master.dc.sync_window.enabled = true;
  project.master.dc.dcm.set_value = kMillisecond;
  project.master.dc.dcm.mode = DcmMode::kOff;
  EXPECT_THAT(found(project),
              ElementsAre("info master.dc.sync_window", "error master.dc.set_value_us", "warning master.dc.mode"));
  project = sample::small_machine();
  project.master.dc.enabled = false;
  EXPECT_THAT(found(project), ElementsAre("info master.dc.enabled"));
}

TEST(Compile, RefusesWhatCannotBeBuilt) {
  EXPECT_EQ(compile(Project{}).error().code, ErrorCode::kConfiguration);
  Project project = sample::small_machine();
  project.master.cycle_time = 31'249;
  EXPECT_EQ(compile(project).error().code, ErrorCode::kBadValue);
  EXPECT_EQ(compile(project).error().subject, "master.cycle_time_us");
  EXPECT_EQ(compile(project).error().detail.text(), "31.249 us is outside 31.25..100000 us") << "as its setting says";
  project.master.cycle_time = 100 * kMillisecond + 1;
  EXPECT_EQ(compile(project).error().code, ErrorCode::kBadValue);
  for (const Nanoseconds cycle : {100 * kMillisecond, Nanoseconds{31'250}}) {
    project.master.cycle_time = cycle;
    EXPECT_TRUE(compile(project)) << cycle;
  }
}

TEST(Compile, TheFirstSlaveWithDcIsTheReference) {
  Project project = sample::project({sample::coupler(), sample::servo(), sample::servo()});
  EXPECT_EQ(compile(project)->config.reference_clock(), 1);
  project.slaves[1].dc.op_mode = "Off";
  EXPECT_EQ(compile(project)->config.reference_clock(), 2);
  project.slaves[1].dc.potential_reference_clock = true;
  EXPECT_EQ(compile(project)->config.reference_clock(), 2);
  EXPECT_TRUE(compile(project)->config.slaves[1].dc->potential_reference_clock);
  project.master.dc.reference_clock = 1;
  const auto config = compile(project)->config;
  EXPECT_EQ(config.reference_clock(), 1);
  EXPECT_EQ(config.slaves[1].dc->assign_activate, 0);
}

TEST(Compile, EqualNamesOfVariablesAreTold) {
  Project project = sample::small_machine();
  project.slaves[1].device.tx_pdos[1].name = "Channel 1";
  const auto config = compile(project)->config;
  EXPECT_EQ(config.image.inputs[0].name, "Slave_1002 [SI1002].Channel 1.Input");
  EXPECT_EQ(config.image.inputs[1].name, "Slave_1002 [SI1002].Channel 1.Input (2)");
}

/// The way through the slaves is an estimate: it warns, and stops nobody.
TEST(Findings, TheWayThroughTheSlavesCountsInTheCycle) {
  Project project = sample::small_machine();
  project.master.cycle_time = 100 * kMicrosecond;
  const auto frames = cycle_need(compile(project)->config).wire;
  while (static_cast<Nanoseconds>(project.slaves.size()) * travel_through("KK") + frames <= project.master.cycle_time) {
    auto slave = project.slaves[1];
    slave.name = "Input " + std::to_string(project.slaves.size());
    slave.station_address = static_cast<std::uint16_t>(2000 + project.slaves.size());
    slave.previous = PreviousPort{static_cast<std::uint16_t>(project.slaves.size() - 1), 1};
    project.slaves.push_back(std::move(slave));
  }
  const auto result = compile(project).value();
  const auto too_short = std::ranges::find(result.findings, "cycle-too-short", &Finding::code);
  ASSERT_NE(too_short, result.findings.end());
  EXPECT_EQ(too_short->severity, Severity::kWarning);
  EXPECT_EQ(too_short->place.key, "master.cycle_time_us");
  EXPECT_THAT(describe(*too_short), testing::HasSubstr("on their way through"));
}

}  // namespace
}  // namespace syncline
