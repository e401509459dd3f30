// SPDX-License-Identifier: Apache-2.0
#include "reports/acceptance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>

#include "record/replay_run.h"
#include "reports/commissioning_report.h"

namespace syncline::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

NetworkConfig machine() {
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = kMillisecond;
  for (const auto* name : {"Coupler", "Servo <left>", "Servo & right"}) config.slaves.emplace_back().name = name;
  config.dc.enabled = true;
  config.dc.sync_window.enabled = true;
  config.dc.sync_window.exponent = 7;
  return config;
}

/// Some seconds of a machine in OP, in sync after the first.
struct MadeRun {
  explicit MadeRun(const NetworkConfig& config = machine()) : record(config) {}

  void go(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      CycleSample sample;
      sample.cycle = ++cycle;
      sample.send_time = kSecond + static_cast<Nanoseconds>(cycle) * kMillisecond;
      sample.master_state = 8;
      sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows | CycleSample::kDcmActive |
                     CycleSample::kReferenceValid;
      sample.slaves_sync = slaves;
      sample.master_sync = master;
      sample.deviation_ns = deviation;
      sample.dcm_error_ns = 3 * filtered;
      sample.dcm_error_filtered_ns = filtered;
      sample.slave_position = static_cast<std::int16_t>(1 + cycle % 2);
      sample.slave_deviation_ns = -static_cast<std::int32_t>(deviation);
      record.add(std::span(&sample, 1));
      if (cycle % 100 == 0) record.add(now(sample.send_time));
    }
  }
  Snapshot now(Nanoseconds time) const {
    Snapshot snapshot;
    snapshot.time = time;
    snapshot.online = true;
    snapshot.state = AlState::kOp;
    snapshot.lost_frames = lost_frames;
    snapshot.slaves.resize(3);
    return snapshot;
  }
  Acceptance judged(const AcceptanceLimits& limits = {}, std::span<const Finding> findings = {}) const {
    return judge(record, findings, limits);
  }

  RunRecord record;
  std::uint64_t cycle = 0, lost_frames = 0;
  std::uint32_t deviation = 40;
  std::int32_t filtered = -900;
  SyncState slaves = SyncState::kInSync, master = SyncState::kInSync;
};

const Criterion& criterion(const Acceptance& acceptance, std::string_view key) {
  for (const auto& each : acceptance.criteria) {
    if (criterion_key(each.kind) == key) return each;
  }
  throw std::out_of_range(std::string(key));
}
std::string found(const Acceptance& acceptance, std::string_view key) { return found_text(criterion(acceptance, key)); }

TEST(Acceptance, ARunInSyncIsAccepted) {
  MadeRun run;
  run.lost_frames = 7;  // of the bring-up: they are no part of it
  run.slaves = SyncState::kBusy;
  run.go(1000);
  run.slaves = SyncState::kInSync;
  run.go(5000);
  const auto acceptance = run.judged({.least_time = 4 * kSecond, .least_margin = 0.5});
  EXPECT_EQ(acceptance.verdict, Verdict::kKept);
  EXPECT_EQ(found(acceptance, "slaves_in_sync"), "in sync for 4.999 s; largest 40 ns, 68 % margin");
  EXPECT_EQ(found(acceptance, "master_in_sync"), "in sync for 5.999 s; largest that lasted 900 ns, 77 % margin");
  EXPECT_EQ(found(acceptance, "lost_frames"), "0");
  EXPECT_EQ(criterion(acceptance, "sm2_missed").verdict, Verdict::kNotJudged);
}

TEST(Acceptance, EachCriterionAloneCanRefuse) {
  struct Case {
    const char* key;
    void (*spoil)(MadeRun& run);
    AcceptanceLimits limits{};
  };
  const std::array cases{Case{"watched_for", [](MadeRun& run) { run.go(10); }, {.least_time = 2 * kSecond}},
                         Case{"slaves_in_sync",
                              [](MadeRun& run) {
                                run.slaves = SyncState::kOutOfSync;
                                run.go(10);
                                run.slaves = SyncState::kInSync;
                                run.go(10);
                              }},
                         Case{"slaves_in_sync", [](MadeRun& run) { run.go(10); }, {.least_margin = 0.7}},
                         Case{"master_in_sync",
                              [](MadeRun& run) {
                                run.filtered = 4'001;
                                run.go(201);
                                run.filtered = 0;
                                run.go(10);
                              }},
                         Case{"lost_frames",
                              [](MadeRun& run) {
                                run.lost_frames = 3;
                                run.go(200);
                              },
                              {.most_lost_frames = 2}},
                         Case{"faults", [](MadeRun& run) {
                                // It follows no clock.
                                run.record.add(Event{kSecond + 500 * kMillisecond, 0, events::SlaveLost{}});
                                run.go(10);
                              }}};
  for (const auto& one : cases) {
    MadeRun run;
    run.go(1000);
    ASSERT_EQ(run.judged().verdict, Verdict::kKept);
    one.spoil(run);
    const auto acceptance = run.judged(one.limits);
    EXPECT_EQ(acceptance.verdict, Verdict::kNotKept) << one.key;
    for (const auto& each : acceptance.criteria)
      EXPECT_EQ(each.verdict == Verdict::kNotKept, criterion_key(each.kind) == one.key)
          << one.key << ": " << criterion_key(each.kind) << ' ' << found_text(each);
  }
  MadeRun run;
  run.go(1000);
  const std::array<Finding, 1> warnings{{{.code = "host-late", .severity = Severity::kWarning}}};
  const auto acceptance = run.judged({}, warnings);
  EXPECT_EQ(acceptance.verdict, Verdict::kNotKept);
  EXPECT_EQ(found(acceptance, "findings"), "0 errors, 1 warning");
}

/// The verdict speaks of those who answer: who follows the reference clock and went is a loss on the page, as it is in
/// the overview, and synchronisation counts from when all were back.
TEST(Acceptance, AFollowerThatWasAwayIsALossOfSynchronisation) {
  MadeRun run;
  run.go(2000);
  run.record.add(Event{kSecond + 1500 * kMillisecond, 1, events::SlaveLost{}});
  run.go(1000);
  run.record.add(Event{kSecond + 2500 * kMillisecond, 1, events::SlavesInSync{}});
  run.go(1000);
  const auto acceptance = run.judged();
  EXPECT_EQ(acceptance.verdict, Verdict::kNotKept);
  EXPECT_EQ(criterion(acceptance, "slaves_in_sync").verdict, Verdict::kNotKept);
  EXPECT_THAT(found(acceptance, "slaves_in_sync"), HasSubstr("in sync for 1.500 s, lost 1 time; largest 40 ns"));
  EXPECT_EQ(criterion(acceptance, "master_in_sync").verdict, Verdict::kKept);
  const auto& lamp = run.record.overview().slaves;
  EXPECT_EQ(lamp.times_any_lost(), criterion(acceptance, "slaves_in_sync").times_lost);
}

TEST(Acceptance, WhatNobodyWatchedIsNotProven) {
  auto config = machine();
  config.dc.sync_window.enabled = false;
  config.dc.dcm.mode = DcmMode::kOff;
  MadeRun run(config);
  run.slaves = run.master = SyncState::kNotMonitored;
  run.go(1000);
  EXPECT_EQ(run.judged().verdict, Verdict::kNotJudged);
  EXPECT_EQ(found(run.judged(), "slaves_in_sync"), "not monitored");
  // That the master is in sync says nothing of slaves that nobody watches.
  config = machine();
  config.dc.sync_window.enabled = false;
  MadeRun unwatched(config);
  unwatched.slaves = SyncState::kNotMonitored;
  unwatched.go(1000);
  EXPECT_EQ(criterion(unwatched.judged(), "master_in_sync").verdict, Verdict::kKept);
  EXPECT_EQ(unwatched.judged().verdict, Verdict::kNotJudged);
  MadeRun never;
  never.slaves = SyncState::kBusy;
  never.go(1000);
  EXPECT_EQ(never.judged().verdict, Verdict::kNotJudged);
  EXPECT_EQ(criterion(never.judged(), "slaves_in_sync").verdict, Verdict::kNotKept);
}

TEST(CommissioningReport, IsOneWholePageWithTheEvidence) {
  MadeRun run;
  run.go(3000);
  run.record.add(RunNote{2 * kSecond, "cable <changed>"});
  CommissioningFacts facts{.machine = "press & co", .date = "2026-03-01 14:05 UTC", .program = "Syncline 1.2"};
  facts.documents = {{"configuration", "press.eni.xml", "abc"}};
  const auto page = commissioning_report(run.record, facts, run.judged());
  tinyxml2::XMLDocument document;
  // The drawing's style and the page's have no markup in them: all of it is well formed but for what HTML leaves open.
  auto xml = page.substr(page.find("<body>"));
  xml = xml.substr(0, xml.find("</html>"));
  ASSERT_EQ(document.Parse(xml.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  for (const char* part :
       {"accepted", "press &amp; co", "Servo &lt;left&gt;", "cable &lt;changed&gt;", "68 % to ±127 ns",
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", "stroke-dasharray", "-40.0"}) {
    EXPECT_THAT(page, HasSubstr(part));
  }
  EXPECT_EQ(page, commissioning_report(run.record, facts, run.judged()));
  run.record.add(Event{3 * kSecond, 1, events::SlaveLost{}});
  const auto spoiled = commissioning_report(run.record, facts, run.judged());
  EXPECT_THAT(spoiled, HasSubstr("NOT ACCEPTED"));
  EXPECT_THAT(spoiled, HasSubstr("<td>Servo &lt;left&gt;</td>"));
}

TEST(CommissioningReport, ARunWithoutValuesSaysSo) {
  const RunRecord record(machine());
  const auto page = commissioning_report(record, {}, judge(record, {}, {}));
  EXPECT_THAT(page, HasSubstr("NOT PROVEN"));
  EXPECT_THAT(page, HasSubstr("There is no value to be drawn."));
}

/// FIPS 180-4's own examples.
TEST(CommissioningReport, DocumentsAreKnownByTheirSha256) {
  EXPECT_EQ(sha256_text(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_text("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

}  // namespace
}  // namespace syncline::reports
