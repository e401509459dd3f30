// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "config/identity.h"
#include "dc/dcm/dcm_controller.h"
#include "dc/dcm/phase_tracker.h"
#include "dc/outlier_gate.h"
#include "dcm_plant.h"
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

PlantOptions with(DcmMode mode, JitterProfile jitter, double ppm = 50) {
  PlantOptions options;
  options.mode = mode;
  options.jitter = jitter;
  options.reference_ppm = ppm;
  options.slave_ppm = {ppm + 30, ppm - 90};
  return options;
}

constexpr DcmMode kControlled[] = {DcmMode::kBusShift, DcmMode::kMasterShift};

TEST(DcmModes, TheStandardsOfTheTaskWithNoisyStamps) {
  struct Profile {
    const char* name;
    JitterProfile jitter;
    double send_delay, rms;
  };
  // Bus shift at 400 ppm is the worst: there the gain of the ESC is highest.
  for (const auto& [profile, jitter, send_delay, rms] : {Profile{"quiet", JitterProfile::quiet(), 33, 30},
                                                         {"desktop", JitterProfile::desktop(), 500, 120},
                                                         {"bad", JitterProfile::bad(), 3300, 700}}) {
    for (const auto mode : kControlled) {
      for (const double ppm : {-400.0, -50.0, 50.0, 400.0}) {
        auto options = with(mode, jitter, ppm);
        options.send_delay = send_delay;
        DcmPlant plant(options);
        plant.run_until(20);
        const auto name = std::string(dcm_mode_name(mode)) + " " + std::to_string(ppm) + " " + profile;
        EXPECT_LT(plant.in_sync_at(), 2) << name;
        EXPECT_EQ(plant.times_lost(), 0) << name;
        const double mean = plant.mean(&PlantCycle::grid_error, 10);
        EXPECT_LT(std::sqrt(std::pow(plant.rms(&PlantCycle::grid_error, 10), 2) - mean * mean), rms) << name;
      }
    }
  }
}

/// It is led back as fast as its loop can, which is no rate at which it and the host drift apart. In long cycles it is
/// no longer where it was before three readings agree.
void lead_back_after_a_step(DcmMode mode, Nanoseconds cycle, double step) {
  auto options = with(mode, JitterProfile::quiet());
  options.cycle = cycle;
  options.set_value = cycle * 2 / 3;
  options.clock_step = {static_cast<int>(8 * kSecond / cycle), step};
  DcmPlant plant(options);
  plant.run_until(16);
  const auto told = std::ranges::find_if(plant.cycles(), [](const auto& c) { return c.state.clock_step.has_value(); });
  ASSERT_NE(told, plant.cycles().end());
  EXPECT_NEAR(static_cast<double>(*told->state.clock_step), step, 10'000);
  EXPECT_TRUE(plant.reported(kDcmErrorOutOfLimit));
  EXPECT_FALSE(plant.reported(kDcmErrorDriftTooHigh));
  for (const auto& each : plant.cycles()) {
    if (each.time < 4) continue;
    ASSERT_LT(std::abs(each.state.drift_ppm), 5) << each.time;
  }
  EXPECT_TRUE(plant.last().state.in_sync);
}

TEST(DcmModes, TheWayBackOfAClockThatSteppedIsNoDriftWhereverItIsLed) {
  for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterRefClock, DcmMode::kLinkLayerRefClock}) {
    for (const auto cycle : {kMillisecond / 4, kMillisecond / 2, kMillisecond, 2 * kMillisecond, 4 * kMillisecond}) {
      for (const double step : {-457e3, -400e3, -60e3, 90e3, 400e3}) {
        SCOPED_TRACE(testing::Message() << dcm_mode_name(mode) << " " << cycle << " " << step);
        lead_back_after_a_step(mode, cycle, step);
      }
    }
  }
}

TEST(DcmModes, MasterRefClockLetsTheJitterThroughThatBusShiftTakesOut) {
  for (const auto& jitter : {JitterProfile::quiet(), JitterProfile::desktop()}) {
    DcmPlant nominal(with(DcmMode::kMasterRefClock, jitter));
    DcmPlant controlled(with(DcmMode::kBusShift, jitter));
    nominal.run_until(20);
    controlled.run_until(20);
    EXPECT_EQ(nominal.last().state.error_code, 0U);
    EXPECT_EQ(nominal.last().state.adjust, 0);
    EXPECT_GT(nominal.rms(&PlantCycle::grid_error, 10), 10 * controlled.rms(&PlantCycle::grid_error, 10));
  }
}

TEST(DcmModes, MasterRefClockNeedsAnAccurateCycleOnly) {
  DcmPlant plant(with(DcmMode::kMasterRefClock, JitterProfile::none()));
  plant.run_until(20);
  EXPECT_LT(plant.in_sync_at(), 2);
  EXPECT_LT(plant.rms(&PlantCycle::grid_error, 10), 30);
}

/// A host that wakes up late is late in the same way every cycle, and the clock has been told the nominal time.
TEST(DcmModes, MasterRefClockIsInSyncWithAHostThatIsAlwaysLate) {
  JitterProfile late;
  late.wake_up = QuantileCurve({{0, 15e3}, {0.5, 16e3}, {1, 17e3}});
  DcmPlant plant(with(DcmMode::kMasterRefClock, late));
  plant.run_until(20);
  EXPECT_TRUE(plant.last().state.in_sync);
  EXPECT_LT(*plant.last().state.in_sync_after, 3 * kSecond);
  EXPECT_NEAR(static_cast<double>(plant.last().state.usual_lateness), 16e3, 300);
  EXPECT_LT(std::abs(plant.last().state.error_filtered), 500);
}

/// Of a frame that leaves far off its usual place the nominal time would lead all clocks away.
TEST(DcmModes, MasterRefClockTellsTheTimeOfAFrameThatIsFarOff) {
  const auto controller = make_dcm_controller(settings_for(DcmMode::kMasterRefClock), kMillisecond, 400'000);
  controller->start(0, 10'600'000, 10 * kMillisecond);
  auto time = 10 * kMillisecond;
  const auto told = [&](Nanoseconds late) {
    return *controller->reference_write(time + late, time) - *controller->reference_write(time, time);
  };
  EXPECT_EQ(told(500'000), 0) << "nobody knows what is usual";
  for (int i = 0; i < 100; ++i) {
    (void)controller->observe({time + 7'000, time, time + 600'000});
    time += kMillisecond;
  }
  const auto nominal = *controller->reference_write(time + 7'000, time);
  EXPECT_EQ(*controller->reference_write(time + 9'500, time), nominal);
  EXPECT_EQ(*controller->reference_write(time + 4'500, time), nominal);
  EXPECT_EQ(*controller->reference_write(time + 507'000, time), nominal + 500'000);
  EXPECT_EQ(*controller->reference_write(time - 3'000, time), nominal - 10'000);
}

/// A stamp that was wrong, or a frame that was held up behind it: its message is paid back at once, or the clock would
/// lead all others away for 64 cycles.
TEST(DcmModes, MasterRefClockTakesBackAMessageThatWasFarWrong) {
  const auto controller = make_dcm_controller(settings_for(DcmMode::kMasterRefClock), kMillisecond, 400'000);
  controller->start(0, 10'600'000, 10 * kMillisecond);
  constexpr Nanoseconds kOffset = 600'000, kUsual = 7'000;
  auto time = 10 * kMillisecond;
  // The clock shows what it was told by a frame that is as late as usual, and `wrong` more by this one.
  const auto cycle = [&](Nanoseconds wrong) {
    time += kMillisecond;
    const auto told = *controller->reference_write(time + kUsual, time);
    return controller->observe({time + kUsual, time, told + wrong}).write_again;
  };
  // The frame of another write, sent a while later: by how much it tells more than the time of its sending.
  const auto second = [&](Nanoseconds later) {
    const auto sent = time + kUsual + later;
    return *controller->reference_write(sent, sent) - (time + later + kOffset);
  };
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(cycle(i % 2 == 0 ? 1'000 : -1'000));
  EXPECT_TRUE(cycle(72'000));
  EXPECT_EQ(second(50'000), 72'000);
  const auto after = time + 50'000 + kOffset;
  EXPECT_FALSE(controller->observe_second_write({time + 57'000, time, after})) << "as much less: it is paid back";
  EXPECT_TRUE(cycle(63'000)) << "another one at once";
  EXPECT_EQ(second(50'000), 63'000);
  EXPECT_FALSE(controller->observe_second_write({time + 57'000, time, time + 50'000 + kOffset}));
  EXPECT_FALSE(cycle(0));
  EXPECT_FALSE(cycle(0));

  EXPECT_TRUE(cycle(-20'000));
  EXPECT_EQ(second(50'000), -20'000);
  EXPECT_TRUE(controller->observe_second_write({time + 57'000, time, time + 50'000 + kOffset + 30'000}))
      << "its stamp was wrong by 30 us, too";
  EXPECT_EQ(second(100'000), 30'000);
  (void)cycle(0);
  (void)cycle(0);

  // The clock shows it in the second message, too, and in the next cycle: it has stepped, and is led back as ever.
  EXPECT_TRUE(cycle(40'000));
  const auto told = time + 50'000 + kOffset + second(50'000);
  EXPECT_FALSE(controller->observe_second_write({time + 57'000, time, told}));
  for (const Nanoseconds still : {39'000, 38'000}) {
    EXPECT_TRUE(cycle(still));
    EXPECT_FALSE(controller->observe_second_write({time + 57'000, time, time + 50'000 + kOffset + second(50'000)}));
  }
  for (const Nanoseconds still : {37'000, 20'000, 4'000}) EXPECT_FALSE(cycle(still));
  EXPECT_FALSE(cycle(1'000));
  EXPECT_TRUE(cycle(40'000));
  EXPECT_FALSE(cycle(0));
}

/// Its loop goes as far towards each message as those of all who follow it: what it is told is its own time, whenever a
/// frame leaves, and a little less than that where it is ahead.
TEST(DcmModes, MasterRefClockPushesASubstitute) {
  const auto controller = make_dcm_controller(settings_for(DcmMode::kMasterRefClock), kMillisecond, 400'000);
  controller->start(0, 10'600'000, 10 * kMillisecond);
  auto time = 10 * kMillisecond;
  // A clock that is `ahead` of its place, and frames that are late by turns, beyond what is usual.
  const auto cycle = [&](Nanoseconds ahead, Nanoseconds wrong_stamp = 0) {
    time += kMillisecond;
    const Nanoseconds late = time / kMillisecond % 2 == 0 ? 9'000 : 5'000;
    return controller->observe({time + late - wrong_stamp, time, time + late + 593'000 + ahead}).write_again;
  };
  const auto told = [&](Nanoseconds late) { return *controller->reference_write(time + late, time) - time; };
  for (int i = 0; i < 100; ++i) (void)cycle(0);
  EXPECT_EQ(told(9'000), told(5'000)) << "the one that is to lead is told the nominal time";

  controller->set_led_by_substitute(true);
  EXPECT_FALSE(controller->reference_write(time, time)) << "where it is nobody knows yet";
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(cycle(400));
  EXPECT_NEAR(told(9'000), 9'000 + 593'000 + 400 - 20, 5);
  EXPECT_NEAR(told(5'000), 5'000 + 593'000 + 400 - 20, 5);
  EXPECT_TRUE(cycle(400, 40'000)) << "a stamp that was wrong";
  EXPECT_NEAR(told(9'000), 9'000 + 40'000 + 593'000 + 400 - 20, 5) << "most of the next one's error is the same";
  EXPECT_FALSE(controller->observe_second_write({time + 50'000, time, time + 50'000 + 593'000 + 380}));
  EXPECT_NEAR(told(9'000), 9'000 + 593'000 + 380 - 20, 5);
  EXPECT_TRUE(controller->observe_second_write({time + 60'000, time, time + 90'000 + 593'000 + 400}));
  EXPECT_FALSE(controller->observe_second_write({time + 70'000, time, {}}));
  (void)cycle(400);
  for (int i = 0; i < 50; ++i) (void)cycle(-5'000);
  EXPECT_FALSE(cycle(-5'000)) << "what stays away is no stamp";
  EXPECT_EQ(told(7'000), 7'000 + 593'000 - 5'000 + 30) << "no faster than those behind it can bear";

  controller->set_led_by_substitute(false);
  EXPECT_EQ(told(9'000), told(5'000));
}

TEST(DcmModes, LinkLayerRefClockTakesTheAdaptersTime) {
  // The adapter's stamps are what the plant hands over; the host's wake-up is of no concern.
  DcmPlant plant(with(DcmMode::kLinkLayerRefClock, JitterProfile::bad()));
  plant.run_until(20);
  EXPECT_LT(plant.in_sync_at(), 2);
  EXPECT_EQ(plant.times_lost(), 0);
  EXPECT_LT(plant.rms(&PlantCycle::grid_error, 10), 30);
  EXPECT_LT(plant.worst(&PlantCycle::slave_error, 10), 30);
}

TEST(DcmModes, AnApplicationThatDoesAsItIsToldIsAMasterShift) {
  auto options = with(DcmMode::kMasterShiftByApp, JitterProfile::quiet());
  options.start_error = 100e3;
  DcmPlant plant(options);
  plant.run_until(10);
  EXPECT_LT(plant.in_sync_at(), 2.5);
  EXPECT_LT(plant.worst(&PlantCycle::grid_error, 8), 50);
}

TEST(DcmModes, NothingMovesByItselfWhenTheApplicationOrNobodyShallMoveIt) {
  for (const auto mode :
       {DcmMode::kMasterShift, DcmMode::kMasterShiftByApp, DcmMode::kBusShift, DcmMode::kMasterRefClock}) {
    auto settings = settings_for(mode);
    settings.control_off = true;
    auto controller = make_dcm_controller(settings, kMillisecond, 600'000);
    controller->start(0, 5'400'000, 0);
    for (Nanoseconds time = kMillisecond; time < kSecond; time += kMillisecond) {
      EXPECT_FALSE(controller->reference_write(time, time));
      EXPECT_EQ(controller->observe({time, time, 5'400'000 + time + time / 20'000}).period_adjust, 0);
    }
    EXPECT_NEAR(controller->state().drift_ppm, 50, 0.1) << "the natural drift";
    if (mode == DcmMode::kMasterShift) {
      EXPECT_LT(controller->state().adjust, -50) << "what would be adjusted";
    }
  }
}

/// What nobody moves leaves its place in time, and that is no error of a control that is switched off.
TEST(DcmModes, AScheduleThatNobodyHoldsReportsNoErrorWhenItLeavesItsPlace) {
  for (const bool off : {false, true}) {
    auto settings = settings_for(DcmMode::kMasterShift);
    settings.control_off = off;
    auto controller = make_dcm_controller(settings, kMillisecond, 600'000);
    controller->start(0, 5'400'000, 0);
    // In its place for 3 s, then away from it at 50 ppm, whatever the controller wants.
    for (Nanoseconds time = kMillisecond; time < 6 * kSecond; time += kMillisecond) {
      const auto drifted = std::max<Nanoseconds>(0, time - 3 * kSecond) / 20'000;
      controller->observe({time, time, 5'400'000 + time + drifted});
    }
    EXPECT_FALSE(controller->state().in_sync);
    EXPECT_EQ(controller->state().error_code, off ? 0 : kDcmErrorOutOfLimit);
  }
}

TEST(DcmModes, AStepOfTheClockIsWorkedOffWithinTheLimitAgain) {
  for (const auto mode : kControlled) {
    auto options = with(mode, JitterProfile::quiet());
    options.clock_step = {8'000, 50e3};
    DcmPlant plant(options);
    plant.run_until(16);
    EXPECT_LT(plant.in_sync_at(), 2);
    EXPECT_GT(plant.worst(&PlantCycle::grid_error, 7.99, 8.1), 40e3);
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 12), 500) << dcm_mode_name(mode);
    EXPECT_TRUE(plant.last().state.in_sync);
  }
}

TEST(DcmModes, TheGainSaysHowMuchOfTheNoiseComesThrough) {
  const auto rms = [](std::uint32_t gain) {
    auto options = with(DcmMode::kMasterShift, JitterProfile::desktop());
    options.stamp_noise = 3'000;
    options.settings.gain_ppt = gain;
    DcmPlant plant(options);
    plant.run_until(20);
    return plant.rms(&PlantCycle::grid_error, 10);
  };
  EXPECT_GT(rms(50), 3 * rms(2));
  EXPECT_EQ(rms(0), rms(2)) << "zero leaves the default";
}

/// Of the first frames their mean, and later a little of each.
TEST(DcmModes, TheUsualLatenessOfFramesIsKnownAtOnce) {
  const auto controller = make_dcm_controller(settings_for(DcmMode::kMasterRefClock), kMillisecond, 400'000);
  controller->start(0, 10'600'000, 10 * kMillisecond);
  auto time = 10 * kMillisecond;
  const auto late = [&](Nanoseconds by) {
    (void)controller->observe({time + by, time, time + 600'000});
    time += kMillisecond;
    return controller->state().usual_lateness;
  };
  EXPECT_EQ(late(5'000), 5'000);
  EXPECT_EQ(late(7'000), 6'000);
  EXPECT_EQ(late(9'000), 7'000);
  for (int i = 0; i < 5'000; ++i) (void)late(7'000);
  EXPECT_NEAR(static_cast<double>(late(900'000)), 7'000 + 2'000.0 / 32, 1) << "no more of one";
  controller->start(0, 10'600'000, time);
  EXPECT_EQ(late(3'000), 3'000) << "begun anew";
}

TEST(DcmModes, TheDriftErrorGainSaysHowFastAChangeOfRateIsFollowed) {
  // A quartz that warms up: 0.1 ppm a second, as a growing error of the stamps would look.
  const auto lag = [](std::uint32_t drift_gain) {
    PhaseTracker tracker({0.002, drift_gain * 0.002 * 0.002 / 4}, 1e6, 3'000);
    double phase = 0, rate = 0;
    for (int i = 0; i < 20'000; ++i) {
      rate += 1e-4;  // ns a cycle, each cycle
      phase += rate - tracker.drift();
      tracker.advance(1, -tracker.drift());
      tracker.update(phase);
    }
    return std::abs(rate - tracker.drift());
  };
  EXPECT_GT(lag(1), 2 * lag(3));
}

TEST(OutlierGate, IsAsWideAsTheLimitOrTheScatterAndBelievesWhatStays) {
  OutlierGate gate(3'000);
  using enum OutlierGate::Verdict;
  EXPECT_EQ(gate.judge(1e6, false), kValid) << "nothing is known yet";
  gate.start();
  EXPECT_EQ(gate.judge(2'999, true), kValid);
  EXPECT_EQ(gate.judge(3'001, true), kOutlier);
  for (int i = 0; i < 1'000; ++i) (void)gate.judge(i % 2 == 0 ? 1'000 : -1'000, true);
  EXPECT_EQ(gate.judge(7'000, true), kValid) << "this host is always that bad";
  EXPECT_EQ(gate.judge(9'000, true), kOutlier);
  for (int i = 0; i < 18; ++i) EXPECT_EQ(gate.judge(50'000, true), kOutlier);
  EXPECT_EQ(gate.judge(50'000, true), kStep);
}

/// A tracker that the timer obeys, with readings that are off by what `noise` says.
struct FollowedRate {
  explicit FollowedRate(double cycle_ns) : tracker({0.002, 3e-6}, cycle_ns, 3'000) {}
  void cycle(double noise) {
    phase += rate - tracker.drift() - 0.1 * tracker.phase();
    tracker.advance(1, -tracker.drift() - 0.1 * tracker.phase());
    tracker.update(phase + noise);
  }
  PhaseTracker tracker;
  double phase = 0, rate = 0;  // ns; ns a cycle
};

/// A time service, from one cycle to the next: with the settled gains alone the phase would be off by 5.2 us at 5 ppm
/// in cycles of 4 ms, for seconds.
TEST(PhaseTracker, FollowsAnotherRateWithoutGoingFarAstray) {
  for (const double cycle : {250e3, 1e6, 4e6}) {
    for (const double ppm : {5.0, -20.0, 60.0}) {
      Random random(11);
      const auto stamps = JitterProfile::quiet().stamp_error;
      FollowedRate follower(cycle);
      for (int i = 0; i < 5'000; ++i) follower.cycle(stamps.at(random.uniform()));
      follower.rate = ppm * 1e-6 * cycle;
      double largest = 0, left = 0;
      for (int i = 0; i < 1'200; ++i) {
        follower.cycle(stamps.at(random.uniform()));
        largest = std::max(largest, std::abs(follower.phase));
        if (i >= 800) left = std::max(left, std::abs(follower.phase));
      }
      EXPECT_LT(largest, 4'500) << ppm << " ppm in " << cycle;
      EXPECT_LT(left, 2'200) << ppm << " ppm in " << cycle;
    }
  }
}

/// Neither the tails of real hosts nor errors that last for some fifty readings are another rate: the drift stays.
TEST(PhaseTracker, TakesNoNoiseForAnotherRate) {
  for (int kind = 0; kind < 4; ++kind) {
    Random random(7);
    const std::array profiles{JitterProfile::quiet(), JitterProfile::desktop(), JitterProfile::bad()};
    FollowedRate follower(1e6);
    double lasting = 0, worst = 0;
    for (int i = 0; i < 200'000; ++i) {
      lasting = 0.98 * lasting + 100 * random.normal();
      follower.cycle(kind < 3 ? profiles[static_cast<std::size_t>(kind)].stamp_error.at(random.uniform()) : lasting);
      if (i > 5'000) worst = std::max(worst, std::abs(follower.tracker.drift()));
    }
    EXPECT_LT(worst, 1) << kind << ", ns a cycle";
  }
}

TEST(PhaseTracker, BeginsAsALineThroughAllReadings) {
  PhaseTracker tracker({0.002, 3e-6}, 1e6, 3'000);
  for (int i = 0; i < 200; ++i) {
    if (i > 0) tracker.advance(1, 0);
    tracker.update(2'000 + 50.0 * i);
  }
  EXPECT_NEAR(tracker.drift(), 50, 0.01);
  EXPECT_NEAR(tracker.phase(), 2'000 + 50.0 * 199, 1);
  tracker.advance(10, -300);
  EXPECT_NEAR(tracker.phase(), 2'000 + 50.0 * 209 - 300, 1);
}

}  // namespace
}  // namespace syncline::dc
