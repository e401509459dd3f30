// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "app/composition/open_link.h"
#include "channels/command.h"
#include "channels/master_channels.h"
#include "compile/compile.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "engine/scan_bus.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_builder.h"
#include "master/master_service.h"
#include "support/clock.h"
#include "support/jitter_profile.h"
#include "tests/support/event_match.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

std::string demo_link(const std::string& options = {}) {
  return "sim:" + test::source_dir() + "/resources/demo/machine.toml?virtual" + options;
}

/// The demonstration machine, scanned, configured and run as a user would.
class DemoMachine : public ::testing::TestWithParam<DcmMode> {
 protected:
  Project project;
  std::vector<Event> events;
  std::vector<CycleSample> samples;

  void SetUp() override {
    const auto scan = scan_bus(open_link(demo_link()));
    ASSERT_TRUE(scan);
    eni::EsiCatalogue catalogue;
    ASSERT_TRUE(catalogue.add_folder(test::source_dir() + "/resources/esi"));
    project = eni::project_from_scan(*scan, catalogue).project;
    project.master.dc.sync_window.enabled = true;
    project.master.dc.dcm.mode = GetParam();
  }

  RunOutcome run(const std::string& link, Nanoseconds duration) {
    const auto compiled = compile(project);
    EXPECT_TRUE(compiled);
    RunRequest request;
    request.duration = duration;
    request.on_event = [this](const Event& event) { events.push_back(event); };
    request.on_samples = [this](std::span<const CycleSample> s) { samples.insert(samples.end(), s.begin(), s.end()); };
    auto outcome = run_network(compiled->config, open_link(link), request);
    EXPECT_TRUE(outcome);
    return outcome ? *outcome : RunOutcome{};
  }
};

TEST_P(DemoMachine, ReachesOpInSync) {
  const auto outcome = run(demo_link(), 20 * kSecond);
  EXPECT_FALSE(outcome.error);
  const auto& report = outcome.report;
  EXPECT_EQ(report.state, AlState::kOp);
  EXPECT_EQ(report.wkc_errors, 0U);
  EXPECT_EQ(report.lost_frames, 0U);
  EXPECT_TRUE(report.dc.monitored);
  EXPECT_EQ(report.dc.state, SyncState::kInSync);
  ASSERT_TRUE(report.deviation_max_ns);
  EXPECT_LT(*report.deviation_max_ns, 100);
  EXPECT_EQ(report.dcm.mode, GetParam());
  EXPECT_EQ(report.dcm.state, SyncState::kInSync);
  EXPECT_LT(report.dcm.in_sync_after_ms.value_or(1e9), 2100);
  EXPECT_LT(report.dcm.error_rms_ns, 2500);
  EXPECT_LT(report.dcm.error_max_ns, 75'000) << "a single stamp of a quiet host is up to 72 us wrong";
  std::size_t counters = 0;
  for (const auto& slave : report.slaves) {
    if (!slave.sm2_missed) continue;
    ++counters;
    EXPECT_EQ(slave.sm2_missed->value, 0U) << slave.name;
  }
  EXPECT_EQ(counters, 3U);  // the drives
}

TEST_P(DemoMachine, CounterOfMissedEventsIsFoundByItsNameWhoeverTheVendorIs) {
  auto compiled = compile(project);
  ASSERT_TRUE(compiled);
  // No table knows these products; the first drive has the older layout, the last one that of ETG.1020.
  for (const std::size_t drive : {3, 4, 5}) compiled->config.slaves[drive].identity.product_code = 0x7777'0000 + drive;
  RunRequest request;
  request.duration = 10 * kSecond;
  const auto outcome = run_network(compiled->config, open_link(demo_link()), request);
  ASSERT_TRUE(outcome);
  ASSERT_TRUE(outcome->report.slaves[3].sm2_missed && outcome->report.slaves[5].sm2_missed);
  EXPECT_EQ(outcome->report.slaves[3].sm2_missed->sub_index, 0x0C);
  EXPECT_EQ(outcome->report.slaves[5].sm2_missed->sub_index, 0x0B);
}

TEST_P(DemoMachine, IsTheSameForTheSameSeedOnly) {
  (void)run(demo_link("&seed=7"), 5 * kSecond);
  const auto first = std::exchange(samples, {});
  (void)run(demo_link("&seed=7"), 5 * kSecond);
  ASSERT_EQ(first.size(), samples.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].send_time, samples[i].send_time);
    ASSERT_EQ(first[i].reference_time, samples[i].reference_time);
    ASSERT_EQ(first[i].deviation_ored_ns, samples[i].deviation_ored_ns);
  }
  samples.clear();
  (void)run(demo_link("&seed=8"), 5 * kSecond);
  bool same = first.size() == samples.size();
  for (std::size_t i = 0; same && i < first.size(); ++i) same = first[i].send_time == samples[i].send_time;
  EXPECT_FALSE(same);
}

/// Largest number of missed SM2 events of a drive when the host wakes up as `jitter` says; a drive that
/// gave up for it counts as a thousand.
std::uint32_t missed_events(const Project& project, const JitterProfile& jitter) {
  auto opened = open_link(demo_link());
  const auto compiled = compile(project);
  auto* clock = opened ? dynamic_cast<VirtualClock*>(opened->clock.get()) : nullptr;
  if (clock == nullptr || !compiled) return ~0U;
  clock->set_wakeup_jitter(jitter, 1);
  MasterService service(std::move(opened->link), *clock);
  service.channels().commands.push(GoOnlineCommand{compiled->config, AlState::kOp});
  service.run_for(20 * kSecond);
  std::uint32_t missed = 0;
  for (const auto& event : service.channels().events.drain()) {
    if (test::with(&events::AlStatusError::al_status_code, 0x001A)(event)) missed = 1000;
  }
  Snapshot snapshot;
  service.channels().snapshot.read(snapshot);
  for (const auto& slave : snapshot.slaves) missed = std::max(missed, slave.sm2_missed.value);
  return missed;
}

TEST_P(DemoMachine, LateWakeUpsMissSm2EventsWhenSyncZeroIsNear) {
  project.master.dc.sync_window.enabled = false;
  EXPECT_EQ(missed_events(project, JitterProfile::desktop()), 0U);
  // The frame and the drives' calc and copy time leave nothing to spare. (Still nearer, each frame would surely be
  // late, and serve the SYNC0 behind the next one.)
  project.master.dc.dcm.set_value = 70 * kMicrosecond;
  EXPECT_GT(missed_events(project, JitterProfile::bad()), 0U);
}

TEST_P(DemoMachine, RunsTheExportedFileLikeTheProject) {
  const auto compiled = compile(project);
  ASSERT_TRUE(compiled);
  const auto text = eni::write_eni(compiled->config);
  const auto read = eni::parse_eni(text, "export");
  ASSERT_TRUE(read);
  RunRequest request;
  request.duration = 8 * kSecond;
  const auto outcome = run_network(*read, open_link(demo_link()), request);
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->error);
  EXPECT_EQ(outcome->report.state, AlState::kOp);
  EXPECT_EQ(outcome->report.dcm.mode, GetParam());
  EXPECT_EQ(outcome->report.dcm.state, SyncState::kInSync);
  EXPECT_EQ(outcome->report.dc.state, SyncState::kInSync);
}

INSTANTIATE_TEST_SUITE_P(BothModes, DemoMachine, ::testing::Values(DcmMode::kBusShift, DcmMode::kMasterShift),
                         [](const auto& mode) {
                           return mode.param == DcmMode::kBusShift ? "BusShift" : "MasterShift";
                         });

}  // namespace
}  // namespace syncline
