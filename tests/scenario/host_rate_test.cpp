// SPDX-License-Identifier: Apache-2.0
// The host's clock runs at another rate from one moment to the next (a time service), or the host does nothing for
// seconds while the clocks run apart.
#include <gtest/gtest.h>

#include <string>

#include "tests/scenario/two_axes_run.h"

namespace syncline {
namespace {

/// Who follows the reference clock by its readings sees the other rate in them, however long the cycle is.
class HostRate : public test::TwoAxesRun {};

TEST_P(HostRate, IsFollowedWithoutLeavingTheReferenceClock) {
  for (const auto& jitter : {JitterProfile::none(), JitterProfile::quiet()}) {
    for (const double ppm : {-5.0, 20.0, -60.0}) {
      auto run = machine;
      run.jitter = run.network.sim.host_jitter = jitter;
      auto& fault = run.fault(FaultKind::kTemperatureRamp, 10 * kSecond);
      fault.until = 10 * kSecond + kMillisecond;
      fault.ppm = ppm;
      run.run(20 * kSecond);
      SCOPED_TRACE(std::to_string(ppm) + " ppm:\n" + run.said());
      EXPECT_NEAR(run.report.dcm.drift_ppm, -5 - ppm, 0.5);
      EXPECT_EQ(run.report.dcm.state, SyncState::kInSync);
      EXPECT_TRUE(run.report.history.master_losses.empty());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MasterShift, HostRate,
                         ::testing::Combine(::testing::Values(DcmMode::kMasterShift),
                                            ::testing::Values(500 * kMicrosecond, kMillisecond, 2 * kMillisecond,
                                                              4 * kMillisecond)));

/// What the clocks ran apart meanwhile is taken back at once: no clock has stepped, and no time service was at work.
class HostAsleep : public test::TwoAxesRun {};

TEST_P(HostAsleep, ForSecondsIsWhatIsTold) {
  for (const auto length : {300 * kMillisecond, kSecond, 3 * kSecond}) {
    auto run = machine;
    run.fault(FaultKind::kHostStall, 8 * kSecond).value_ns = length;
    run.run(20 * kSecond);
    SCOPED_TRACE(std::to_string(length) + " ns:\n" + run.said());
    EXPECT_TRUE(run.found(code::kHostStalled));
    for (const auto code : {code::kWindowLeft, code::kMissedByMovedClock, code::kJitterReachesClock, code::kDcmError})
      EXPECT_FALSE(run.found(code)) << code;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, HostAsleep,
                         ::testing::Combine(::testing::Values(DcmMode::kBusShift, DcmMode::kMasterShift,
                                                              DcmMode::kMasterRefClock),
                                            ::testing::Values(500 * kMicrosecond, kMillisecond, 4 * kMillisecond)));

}  // namespace
}  // namespace syncline
