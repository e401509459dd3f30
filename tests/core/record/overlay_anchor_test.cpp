// SPDX-License-Identifier: Apache-2.0
#include "record/overlay_anchor.h"

#include <gtest/gtest.h>

#include <memory>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/event_finding.h"
#include "config/network_config.h"
#include "findings/finding.h"
#include "protocol/al_state.h"
#include "record/run_record.h"
#include "trace/trigger.h"

namespace syncline {
namespace {

/// A run that begins at `begin`, is in sync from 20 ms on, and whose error jumps at `jump` ms.
std::unique_ptr<RunRecord> overlaid(Nanoseconds begin, int jump) {
  NetworkConfig config;
  config.slaves.resize(1);
  auto run = std::make_unique<RunRecord>(config, 1000, RunLimits{kMillisecond, 0, 4'000}, 0x1000);
  std::vector<CycleSample> samples(100);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    auto& sample = samples[i];
    sample.cycle = i + 1;
    sample.send_time = begin + static_cast<Nanoseconds>(i) * kMillisecond;
    sample.master_state = static_cast<std::uint8_t>(AlState::kOp);
    sample.flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
    sample.reference_time = sample.send_time;
    sample.master_sync = i < 20 ? SyncState::kBusy : SyncState::kInSync;
    sample.dcm_error_ns = static_cast<int>(i) < jump ? 10 : 3'000;
  }
  run->add(samples);
  run->add(Event{begin + jump * kMillisecond + 7, 0, events::SlaveLost{}});
  return run;
}

constexpr Nanoseconds kOne = 830'000'000 * kSecond + 123'456'789, kTwo = 700'000'000 * kSecond + 987'654'321;

TEST(OverlayAnchor, TheMomentsOfBothLieOverEachOtherToTheNanosecond) {
  const auto one = overlaid(kOne, 50), two = overlaid(kTwo, 71);
  Trigger trigger;
  trigger.signal = Signal::kDcmError;
  trigger.level = 1'000;
  EXPECT_EQ(overlay_offset(*one, *two, OverlayAlignment::kBegin, trigger), 0);
  EXPECT_EQ(overlay_anchor(*one, OverlayAlignment::kArmed, trigger), kOne + 20 * kMillisecond);
  EXPECT_EQ(overlay_offset(*one, *two, OverlayAlignment::kArmed, trigger), 0);
  EXPECT_EQ(overlay_anchor(*two, OverlayAlignment::kTrigger, trigger), kTwo + 71 * kMillisecond);
  EXPECT_EQ(overlay_offset(*one, *two, OverlayAlignment::kTrigger, trigger), -21 * kMillisecond);
  EXPECT_EQ(overlay_offset(*two, *one, OverlayAlignment::kTrigger, trigger), 21 * kMillisecond);
  // Of an event, whatever the mode and the hold-off of the panel are.
  const auto told = event_finding(one->events().front());
  ASSERT_TRUE(told);
  trigger.kind = Trigger::Kind::kEvent;
  trigger.code = told->code;
  EXPECT_EQ(overlay_anchor(*two, OverlayAlignment::kTrigger, trigger), kTwo + 71 * kMillisecond + 7);
}

TEST(OverlayAnchor, AFindingLiesWhereItBegan) {
  const auto run = overlaid(kOne, 50);
  run->restore({Finding{"slave-fell", Severity::kError, 0, kOne + 33 * kMillisecond, kOne + 40 * kMillisecond}});
  Trigger trigger;
  trigger.kind = Trigger::Kind::kFinding;
  trigger.code = "slave-fell";
  EXPECT_EQ(overlay_anchor(*run, OverlayAlignment::kTrigger, trigger), kOne + 33 * kMillisecond);
}

TEST(OverlayAnchor, WhatARunHasNotIsNone) {
  const auto one = overlaid(kOne, 50), never = overlaid(kTwo, 1000);
  Trigger trigger;
  trigger.signal = Signal::kDcmError;
  trigger.level = 1'000;
  EXPECT_FALSE(overlay_offset(*one, *never, OverlayAlignment::kTrigger, trigger));
  trigger.signal = Signal::kSlaveDeviation;
  trigger.slave = 5;
  EXPECT_FALSE(overlay_anchor(*one, OverlayAlignment::kTrigger, trigger)) << "it has no such slave";
  const RunRecord empty{NetworkConfig{}};
  EXPECT_FALSE(overlay_offset(*one, empty, OverlayAlignment::kBegin, trigger));
  EXPECT_FALSE(overlay_anchor(empty, OverlayAlignment::kArmed, trigger));
}

}  // namespace
}  // namespace syncline
