// SPDX-License-Identifier: Apache-2.0
#include "trace/range_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "trace/sync_overview.h"

namespace syncline {
namespace {

Nanoseconds moment(std::int64_t ms) { return 830'000'000 * kSecond + ms * kMillisecond; }

CycleSample made_cycle(std::int64_t ms) {
  CycleSample s;
  s.cycle = static_cast<std::uint64_t>(ms);
  s.send_time = moment(ms);
  s.flags = CycleSample::kFollowersRead | CycleSample::kDcmActive | CycleSample::kReferenceValid;
  s.master_state = static_cast<std::uint8_t>(ms < 50 ? AlState::kSafeop : AlState::kOp);
  s.slaves_sync = s.master_sync = SyncState::kInSync;
  s.deviation_ns = static_cast<std::uint32_t>(10 + ms % 7);
  s.dcm_error_ns = static_cast<std::int32_t>(ms % 2 == 0 ? ms : -ms);
  s.drift_ppm = -1.5F;
  return s;
}

const RangeFigure& figure_of(const RangeFigures& figures, Signal signal) {
  return std::ranges::find(figures.signals(), signal, &RangeFigures::OfSignal::signal)->figure;
}

TEST(RangeFigures, AreThoseOfTheOverviewSinceItWasArmed) {
  std::vector<CycleSample> samples;
  for (int ms = 0; ms < 200; ++ms) samples.push_back(made_cycle(ms));
  OverviewRecorder recorder(1);
  recorder.add(samples);
  const auto& overview = recorder.overview();
  ASSERT_EQ(overview.armed, moment(50));
  RangeFigures figures(1, *overview.armed, INT64_MAX, true);
  figures.add(samples);
  const auto& error = figure_of(figures, Signal::kDcmError);
  EXPECT_EQ(error.statistics.count(), 150U);
  EXPECT_EQ(error.statistics.mean(), overview.dcm_error.statistics.mean());
  EXPECT_EQ(error.statistics.rms(), overview.dcm_error.statistics.rms());
  EXPECT_EQ(error.quantile(0.9999), overview.dcm_error.magnitudes.percentile(0.9999));
  EXPECT_EQ(error.largest->time, overview.dcm_error.largest->time);
  EXPECT_EQ(error.largest->value, -199);
  EXPECT_EQ(error.newest->time, overview.dcm_error.now->time);
  EXPECT_EQ(figure_of(figures, Signal::kDeviation).margin(32), overview.deviation.margin(32));
}

TEST(RangeFigures, AStretchIsItsCyclesAlone) {
  std::vector<CycleSample> samples;
  for (int ms = 0; ms < 200; ++ms) {
    samples.push_back(made_cycle(ms));
    auto& one = samples.back();
    if (ms == 20) one.frames_lost = 2;
    if (ms == 100) one.frames_lost = 1;
    if (ms == 30) one.flags |= CycleSample::kWkcError;
    one.sm2_position = 1;
    one.slave_sm2_missed = ms < 15 ? 3 : 7;
    one.slave_position = 0;
    one.slave_deviation_ns = -ms;
    if (ms % 2 == 0) one.flags |= CycleSample::kSlaveFollows;
  }
  RangeFigures figures(3, moment(10), moment(40), false);
  figures.add(samples);
  EXPECT_EQ(figures.cycles(), 30U) << "in SAFEOP, too";
  EXPECT_EQ(figures.lost_frames(), 2U);
  EXPECT_EQ(figures.wkc_errors(), 1U);
  EXPECT_EQ(figure_of(figures, Signal::kDcmError).largest->value, -39);
  EXPECT_EQ(figure_of(figures, Signal::kDcmError).newest->time, moment(39));
  const auto& drift = figure_of(figures, Signal::kDrift);
  EXPECT_FALSE(drift.quantile(0.9999)) << "not whole";
  EXPECT_EQ(drift.statistics.mean(), -1.5);
  EXPECT_EQ(figure_of(figures, Signal::kFrameLateBy).statistics.count(), 0U);
  EXPECT_FALSE(figure_of(figures, Signal::kFrameLateBy).quantile(0.5));
  EXPECT_EQ(figures.slaves()[0].deviation.statistics.count(), 15U);
  EXPECT_EQ(figures.slaves()[0].deviation.largest->value, -38);
  EXPECT_FALSE(figures.slaves()[0].missed) << "it has no counter";
  EXPECT_EQ(figures.slaves()[1].missed, 4U) << "what it had before does not count";
  EXPECT_EQ(figures.slaves()[2].deviation.statistics.count(), 0U);
}

}  // namespace
}  // namespace syncline
