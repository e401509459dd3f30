// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "config/dcm_settings.h"
#include "dc/clock_registers.h"
#include "dc/dcm/dcm_controller.h"
#include "protocol/dcm_error.h"
#include "support/random.h"

namespace syncline::dc {
namespace {

constexpr Nanoseconds kCycle = kMillisecond;
constexpr Nanoseconds kSetValue = 600 * kMicrosecond;

/// A host that sends, and a reference clock that is `ppm` faster. In bus shift the clock follows what it is
/// told with the time constant of an ESC's loop (integral learning included); a burst has taught it most of
/// its drift before the frames begin.
class Plant {
 public:
  Plant(DcmMode mode, double ppm, double host_jitter_ns, std::uint64_t seed = 1)
      : ppm_(ppm), jitter_(host_jitter_ns), random_(seed), learned_(mode == DcmMode::kBusShift ? 0.9 * ppm : 0) {
    if (mode != DcmMode::kBusShift) reference_ += 123'000;  // away from the grid; bus shift chooses its grid there
    DcmSettings settings;
    settings.mode = mode;
    controller = make_dcm_controller(settings, kCycle, kSetValue);
    controller->start(7'000 + kSetValue, reference_now(), schedule_);
  }

  /// One cycle; `lost`: the frame does not come back. `late`: extra wake-up delay.
  void cycle(bool lost = false, Nanoseconds late = 0) {
    const auto lateness = static_cast<Nanoseconds>(std::abs(random_.normal()) * jitter_) + late;
    const auto send = schedule_ + lateness;
    advance(send);
    const auto write = controller->reference_write(send, schedule_);
    DcmObservation observation{send, schedule_, lost ? std::optional<Nanoseconds>{} : reference_now()};
    if (write && !lost) steer(*write);
    const auto action = controller->observe(observation);
    schedule_ += kCycle + action.period_adjust;
    ++cycles;
  }
  void run(int count) {
    for (int i = 0; i < count; ++i) cycle();
  }
  /// Of the schedule in the SYNC0 grid, ns.
  [[nodiscard]] double phase_error() const {
    const auto at_schedule = reference_ + (1 + rate()) * static_cast<double>(schedule_ - host_);
    return static_cast<double>(wrap_to_half(static_cast<Nanoseconds>(at_schedule) - 7'000, kCycle));
  }

  std::unique_ptr<DcmController> controller;
  int cycles = 0;

 private:
  [[nodiscard]] Nanoseconds reference_now() const { return static_cast<Nanoseconds>(reference_); }
  [[nodiscard]] double rate() const { return (ppm_ - correction_ - learned_) * 1e-6; }
  void advance(Nanoseconds host) {
    reference_ += (1 + rate()) * static_cast<double>(host - host_);
    host_ = host;
  }
  void steer(Nanoseconds write) {
    const double difference = reference_ - static_cast<double>(write);
    correction_ = std::clamp(difference * 0.0119, -763.0, 763.0);  // ppm a count near zero, 0x0930 = 0x1000
    learned_ += (correction_) / 4096.0;
  }

  double ppm_, jitter_;
  Random random_;
  double reference_ = 7'000;
  double correction_ = 0, learned_;  // ppm
  Nanoseconds host_ = 0, schedule_ = 0;
};

class DcmModes : public testing::TestWithParam<DcmMode> {};

TEST_P(DcmModes, LocksWithinTwoSecondsAndStays) {
  for (const double ppm : {-50.0, 50.0}) {
    Plant plant(GetParam(), ppm, 3'000);
    plant.run(2'000);
    EXPECT_TRUE(plant.controller->state().in_sync) << ppm;
    ASSERT_TRUE(plant.controller->state().in_sync_after);
    EXPECT_LE(*plant.controller->state().in_sync_after, 2 * kSecond);
    plant.run(8'000);
    EXPECT_TRUE(plant.controller->state().in_sync);
    EXPECT_EQ(plant.controller->state().error_code, 0U);
    EXPECT_LT(std::abs(plant.controller->state().error_filtered), 100);
  }
}

TEST_P(DcmModes, OneLateCycleIsNoLossAndABurstOfLossesIsRiddenOut) {
  Plant plant(GetParam(), 50, 200);
  plant.run(5'000);
  ASSERT_TRUE(plant.controller->state().in_sync);
  plant.cycle(false, 400 * kMicrosecond);
  plant.run(20);
  EXPECT_TRUE(plant.controller->state().in_sync);
  for (int i = 0; i < 50; ++i) plant.cycle(true);
  plant.run(1);
  EXPECT_LT(std::abs(plant.controller->state().error), 4'000) << "coasting keeps the phase";
  plant.run(2'000);
  EXPECT_TRUE(plant.controller->state().in_sync);
}

INSTANTIATE_TEST_SUITE_P(Modes, DcmModes, testing::Values(DcmMode::kBusShift, DcmMode::kMasterShift));

TEST(MasterShift, ReadsTheDriftAndBringsTheScheduleToTheSetValue) {
  for (const double ppm : {-400.0, -50.0, 12.5, 50.0, 400.0}) {
    Plant plant(DcmMode::kMasterShift, ppm, 200);
    plant.run(10'000);
    EXPECT_TRUE(plant.controller->state().in_sync) << ppm;
    EXPECT_NEAR(plant.controller->state().drift_ppm, ppm, 0.5) << ppm;
    EXPECT_NEAR(plant.phase_error(), 0, 100) << ppm;
  }
}

TEST(MasterShift, OneSidedJitterIsNoBias) {
  Plant plant(DcmMode::kMasterShift, 50, 20'000);
  plant.run(10'000);
  // The mean wake-up delay is 16 us; the schedule must not sit early by it.
  EXPECT_NEAR(plant.phase_error(), 0, 200);
}

TEST(MasterShift, DriftBeyondBalanceIsSaid) {
  Plant plant(DcmMode::kMasterShift, 900, 0);
  plant.run(3'000);
  EXPECT_EQ(plant.controller->state().error_code, kDcmErrorDriftTooHigh);
}

TEST(DcmOff, ShowsTheNaturalDriftAndControlsNothing) {
  Plant plant(DcmMode::kOff, 30, 0);
  plant.run(2'000);
  EXPECT_NEAR(plant.controller->state().drift_ppm, 30, 0.1);
  EXPECT_FALSE(plant.controller->state().in_sync);
}

}  // namespace
}  // namespace syncline::dc
