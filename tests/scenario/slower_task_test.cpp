// SPDX-License-Identifier: Apache-2.0
// A drive whose outputs come with every third cycle, and SYNC0 with them.
#include <gtest/gtest.h>

#include "config/project.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

constexpr int kSlow = 1;

test::DiagnosedRun machine() {
  test::DiagnosedRun made;
  made.network.add(test::io8());
  for (int i = 0; i < 2; ++i) made.network.add(test::servo(), "servo-y");
  auto& project = made.network.project;
  project.master.tasks.push_back({.name = "slow", .multiple = 3});
  project.master.sync_units.push_back({.name = "slow", .task = "slow"});
  project.slaves[kSlow].output_unit = project.slaves[kSlow].input_unit = "slow";
  project.master.dc.sync_window.enabled = true;
  return made;
}

TEST(SlowerTask, ADriveOfItIsFoundHealthy) {
  auto run = machine();
  run.run(20 * kSecond);
  EXPECT_TRUE(run.findings.empty()) << run.said();
}

/// Of three frames in a row one was to bring its outputs.
TEST(SlowerTask, AMissedEventOfItIsThatOfTheFrameThatWasLost) {
  auto run = machine();
  run.network.sim.slaves[kSlow].oscillator.ppm = 20;
  for (int i = 0; i < 5; ++i) run.fault(FaultKind::kLoseFrames, (6 + i) * kSecond + i * kMillisecond).count = 3;
  run.run(20 * kSecond);
  EXPECT_TRUE(run.found(code::kFramesLost)) << run.said();
  EXPECT_FALSE(run.found(code::kMissedUnexplained)) << run.said();
  const auto& missed = run.report.slaves[kSlow].sm2_missed;
  EXPECT_TRUE(missed && missed->missed > 0) << run.said();
}

/// However many cycles it left out: more than one period, a part of one.
TEST(SlowerTask, WhatItMissedInAStandstillOfTheHostIsTheHosts) {
  for (const auto held : {4, 5, 6}) {
    auto run = machine();
    run.fault(FaultKind::kHostStall, 8 * kSecond).value_ns = held * kMillisecond;
    run.run(20 * kSecond);
    EXPECT_TRUE(run.found(code::kHostStalled)) << run.said();
    EXPECT_FALSE(run.found(code::kMissedUnexplained)) << run.said();
  }
}

}  // namespace
}  // namespace syncline
