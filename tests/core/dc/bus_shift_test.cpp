// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/bus_shift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dcm_plant.h"
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

PlantOptions bus_shifted(JitterProfile jitter, double ppm = 50) {
  PlantOptions options;
  options.mode = DcmMode::kBusShift;
  options.jitter = jitter;
  options.reference_ppm = ppm;
  options.slave_ppm = {ppm + 30, ppm - 90};
  return options;
}

TEST(BusShift, ReferenceClockFollowsTheHostAndSlavesFollowIt) {
  for (const auto& jitter : {JitterProfile::none(), JitterProfile::quiet(), JitterProfile::desktop()}) {
    for (const double ppm : {-400.0, -50.0, 0.0, 50.0, 400.0}) {
      DcmPlant plant(bus_shifted(jitter, ppm));
      plant.run_until(20);
      EXPECT_LT(plant.in_sync_at(), 1.6) << ppm;
      EXPECT_EQ(plant.times_lost(), 0) << ppm;
      EXPECT_LT(plant.worst(&PlantCycle::grid_error, 5), 40) << ppm;
      EXPECT_LT(plant.worst(&PlantCycle::slave_error, 1), 50) << ppm;
      EXPECT_LT(plant.worst(&PlantCycle::deviation, 1), 50) << ppm;
      EXPECT_NEAR(plant.last().state.drift_ppm, 0, 0.2);
      EXPECT_EQ(plant.last().state.error_code, 0U);
    }
  }
}

TEST(BusShift, LearnsTheDriftWithoutABurst) {
  auto options = bus_shifted(JitterProfile::quiet());
  options.learned_share = 0;
  DcmPlant plant(options);
  plant.run_until(40);
  EXPECT_LT(plant.in_sync_at(), 5);
  EXPECT_LT(plant.worst(&PlantCycle::grid_error, 30), 20);
  EXPECT_LT(plant.worst(&PlantCycle::slave_error, 30), 50);
}

TEST(BusShift, RestOfTheDriftThatTheBurstLeftIsNoLongLag) {
  // A tenth is still to be learned; with the share alone it would leave 2 us that fade over many seconds.
  for (const double ppm : {-50.0, 50.0}) {
    auto options = bus_shifted(JitterProfile::desktop(), ppm);
    options.learned_share = 0.9;
    DcmPlant plant(options);
    plant.run_until(15);
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 1.6), 300) << ppm;
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 10), 40) << ppm;
  }
}

TEST(BusShift, DoesNotSwingWhereTheEscsGainIsHigh) {
  // Near the end of its speed counter an ESC reacts a hundred times as strongly as near zero.
  for (const Nanoseconds cycle : {250'000, 1'000'000}) {
    for (const double ppm : {-550.0, 550.0}) {
      auto options = bus_shifted(JitterProfile::desktop(), ppm);
      options.cycle = cycle;
      options.set_value = cycle * 2 / 3;
      DcmPlant plant(options);
      plant.run_until(12);
      EXPECT_EQ(plant.times_lost(), 0) << cycle;
      EXPECT_LT(plant.worst(&PlantCycle::grid_error, 5), 100) << cycle << " " << ppm;
    }
  }
}

/// In cycles the ESC's filter has its share in the loop, in seconds its rate: with an integral of a fixed time the
/// clock swung by tens of microseconds in long cycles, and in short ones with a small gain.
TEST(BusShift, SwingsInNoCycleWithNoGain) {
  for (const auto& [gain, drift_gain] :
       {std::pair{1U, 3U}, {1U, 16U}, {2U, 3U}, {2U, 16U}, {8U, 16U}, {20U, 16U}, {500U, 16U}}) {
    for (const Nanoseconds cycle : {62'500, 125'000, 500'000, 2'000'000, 10'000'000, 20'000'000}) {
      auto options = bus_shifted(JitterProfile::quiet());
      options.settings.gain_ppt = gain;
      options.settings.drift_error_gain = drift_gain;
      options.cycle = cycle;
      options.set_value = cycle * 2 / 3;
      DcmPlant plant(options);
      const double seconds = std::max(30.0, static_cast<double>(cycle) * 10'000 / 1e9);
      plant.run_until(seconds);
      EXPECT_EQ(plant.times_lost(), 0) << gain << " " << drift_gain << " " << cycle;
      EXPECT_LT(plant.worst(&PlantCycle::grid_error, seconds / 2), 50) << gain << " " << drift_gain << " " << cycle;
    }
  }
}

/// A clock that is a little away from its place, as after an outage, does not go as far past it: its own filter of 64
/// messages is a quarter of a second behind at 4 ms.
TEST(BusShift, GoesLittlePastItsPlaceInLongCycles) {
  for (const auto cycle : {kMillisecond, 2 * kMillisecond, 4 * kMillisecond, 10 * kMillisecond}) {
    PlantOptions options;
    options.mode = DcmMode::kBusShift;
    options.settings = settings_for(options.mode);
    options.cycle = cycle;
    options.set_value = cycle / 2;
    constexpr double kStep = 3'500;
    options.clock_step = {static_cast<int>(30 * kSecond / cycle), kStep};
    DcmPlant plant(options);
    plant.run_until(40);
    double past = 0;
    for (const auto& each : plant.cycles()) {
      if (each.time > 30.1) past = std::max(past, -each.grid_error);
    }
    EXPECT_LT(past, 0.4 * kStep) << cycle;
  }
}

/// Nobody told it the time for a while: those who follow it are near it on its way back, which takes no longer than it
/// must. (They were up to 780 ns off.)
TEST(BusShift, LeadsAClockBackSlowlyThatWentALittleAwayUnheard) {
  for (const auto cycle : {kMillisecond, 2 * kMillisecond, 4 * kMillisecond}) {
    PlantOptions options;
    options.mode = DcmMode::kBusShift;
    options.settings = settings_for(options.mode);
    options.cycle = cycle;
    options.set_value = cycle / 2;
    options.clock_step = {static_cast<int>(25 * kSecond / cycle), -12'000};
    options.lost = [cycle](int number) { return number > 20 * kSecond / cycle && number < 29 * kSecond / cycle; };
    DcmPlant plant(options);
    plant.run_until(45);
    EXPECT_LT(plant.worst(&PlantCycle::slave_error, 29.1), 400) << cycle << ": of slaves that average 16 messages";
    EXPECT_GT(plant.worst(&PlantCycle::grid_error, 29.1, 29.2), 10'000) << cycle;
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 33), 4'000) << cycle;
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 40), 500) << cycle;
    EXPECT_TRUE(plant.last().state.in_sync);
  }
}

TEST(BusShift, MovesToTheGridWithoutAStep) {
  for (const double error : {-200e3, 100e3}) {
    auto options = bus_shifted(JitterProfile::quiet());
    options.start_error = error;
    DcmPlant plant(options);
    plant.run_until(12);
    EXPECT_LT(plant.in_sync_at(), 4) << error;
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 10), 200) << error;
    // An ESC cannot go faster than 763 ppm; a step would show as more from one cycle to the next.
    const auto& cycles = plant.cycles();
    for (std::size_t i = 1; i < cycles.size(); ++i) {
      const double moved = cycles[i].grid_error - cycles[i - 1].grid_error;
      ASSERT_LT(std::abs(moved), 900) << i;
    }
  }
}

TEST(BusShift, OneLateCycleDisturbsNobody) {
  auto options = bus_shifted(JitterProfile::quiet());
  options.late = [](int cycle) { return cycle == 8'000 ? 900e3 : 0.0; };
  DcmPlant plant(options);
  plant.run_until(12);
  EXPECT_EQ(plant.times_lost(), 0);
  EXPECT_LT(plant.worst(&PlantCycle::grid_error, 6), 30);
  EXPECT_LT(plant.worst(&PlantCycle::slave_error, 6), 30);
}

TEST(BusShift, ABurstOfLostFramesDisturbsNobody) {
  auto options = bus_shifted(JitterProfile::quiet());
  options.lost = [](int cycle) { return cycle >= 8'000 && cycle < 8'150; };
  DcmPlant plant(options);
  plant.run_until(12);
  EXPECT_EQ(plant.times_lost(), 0);
  EXPECT_LT(plant.worst(&PlantCycle::grid_error, 6), 100);
  EXPECT_LT(plant.worst(&PlantCycle::slave_error, 6), 100);
}

/// What it says of itself: what it writes beyond the forecast, of it what it has learned, and all of it in one.
TEST(BusShift, SaysWhatItWrites) {
  constexpr Nanoseconds kLag = 500;
  BusShift shift(settings_for(DcmMode::kBusShift), kMillisecond, 400'000);
  shift.start(0, 10'600'000, 10 * kMillisecond);
  Nanoseconds total = 0;
  for (auto time = 10 * kMillisecond; time < kSecond; time += kMillisecond) {
    (void)shift.observe({time, time, time + 600'000 + kLag});
    const auto& state = shift.state();
    EXPECT_NEAR(static_cast<double>(state.adjust), -0.2 * kLag + state.output_sum, 0.5);
    total += state.adjust;
    EXPECT_EQ(state.output_total, total);
    EXPECT_EQ(shift.reference_write(time + kMillisecond, time + kMillisecond),
              time + kMillisecond + 600'000 + kLag + state.adjust);
  }
  EXPECT_NEAR(shift.state().output_sum, -kLag * 0.96 / 2.5, 5) << "7.5 s by the drift error gain";
}

TEST(BusShift, SilenceOfTheReferenceClockLosesTheLock) {
  auto options = bus_shifted(JitterProfile::quiet());
  options.lost = [](int cycle) { return cycle >= 5'000 && cycle < 6'000; };
  DcmPlant plant(options);
  plant.run_until(5.5);
  EXPECT_FALSE(plant.last().state.in_sync);
  EXPECT_EQ(plant.last().state.error_code, 0U) << "nobody knows of an error";
  plant.run_until(9);
  EXPECT_TRUE(plant.last().state.in_sync);
}

TEST(BusShift, NoiseOfTheSendStampsStaysAwayFromTheSlaves) {
  auto options = bus_shifted(JitterProfile::desktop());
  options.stamp_noise = 500;
  DcmPlant plant(options);
  plant.run_until(30);
  EXPECT_EQ(plant.times_lost(), 0);
  // Written as it is, that noise moves the slaves by 200 ns.
  EXPECT_LT(plant.worst(&PlantCycle::slave_error, 10), 100);
  EXPECT_LT(plant.worst(&PlantCycle::deviation, 10), 100);
  EXPECT_LT(plant.rms(&PlantCycle::grid_error, 10), 60);
}

TEST(BusShift, StampsThatAreWrongByTensOfMicrosecondsNowAndThenStayAwayFromTheSlaves) {
  for (const double ppm : {-50.0, 50.0}) {
    auto options = bus_shifted(JitterProfile::quiet(), ppm);
    options.stamp_error = options.jitter.stamp_error;
    DcmPlant plant(options);
    plant.run_until(30);
    EXPECT_EQ(plant.times_lost(), 0);
    EXPECT_LT(plant.worst(&PlantCycle::slave_error, 5), 75) << "144 when the next cycle takes them back " << ppm;
  }
}

TEST(BusShift, StaysInSyncWithStampsOfAFewMicroseconds) {
  auto options = bus_shifted(JitterProfile::desktop());
  options.stamp_noise = 3'000;
  DcmPlant plant(options);
  plant.run_until(30);
  EXPECT_LT(plant.in_sync_at(), 2);
  EXPECT_EQ(plant.times_lost(), 0);
  EXPECT_LT(plant.rms(&PlantCycle::grid_error, 10), 500);
}

TEST(BusShift, HoldsAtShortAndLongCycles) {
  for (const Nanoseconds cycle : {62'500, 125'000, 250'000, 2'000'000, 4'000'000}) {
    auto options = bus_shifted(JitterProfile::desktop());
    options.cycle = cycle;
    options.set_value = cycle * 2 / 3;
    DcmPlant plant(options);
    plant.run_until(10);
    EXPECT_LT(plant.in_sync_at(), 2) << cycle;
    EXPECT_EQ(plant.times_lost(), 0) << cycle;
    EXPECT_LT(plant.worst(&PlantCycle::grid_error, 5), 100) << cycle;
    EXPECT_LT(plant.worst(&PlantCycle::slave_error, 5), 100) << cycle;
  }
}

TEST(BusShift, NoSlowBeatBetweenTheTwoClocks) {
  DcmPlant plant(bus_shifted(JitterProfile::desktop(), 50));
  plant.run_until(70);
  for (double from = 10; from < 65; from += 5) {
    EXPECT_LT(std::abs(plant.mean(&PlantCycle::grid_error, from, from + 5)), 10) << from;
  }
}

TEST(BusShift, AReferenceClockThatCannotFollowIsADriftTooHigh) {
  for (const double ppm : {-800.0, 800.0}) {
    DcmPlant plant(bus_shifted(JitterProfile::quiet(), ppm));
    plant.run_until(10);
    EXPECT_EQ(plant.last().state.error_code, kDcmErrorDriftTooHigh) << ppm;
    // It slides through the grid again and again, and is never in sync on its way.
    EXPECT_EQ(plant.in_sync_at(), DcmPlant::kEnd) << ppm;
  }
}

/// A controller in sync whose reference clock runs with the host, at host time `now`; the clock shows `shown`.
struct Settled {
  static constexpr Nanoseconds kLate = 40'000;
  BusShift controller{settings_for(DcmMode::kBusShift), kMillisecond, 600'000};
  Nanoseconds now = 1'000 * kMillisecond, shown = 5'400'000;

  Settled() {
    controller.start(0, shown, now);
    for (int i = 0; i < 3'000; ++i) cycle(0);
  }
  /// The frame leaves `late` after its stamp. `known`: the link says so.
  DcmAction cycle(Nanoseconds late, bool known = false) {
    now += kMillisecond;
    shown += kMillisecond;
    return controller.observe(observation(late, known));
  }
  [[nodiscard]] DcmObservation observation(Nanoseconds late, bool known) const {
    DcmObservation seen{known ? now + late : now, now, shown + late};
    if (known) seen.way_out = late;
    return seen;
  }
  /// What the next write tells the clock too much, when it leaves on time.
  [[nodiscard]] Nanoseconds too_much() { return *controller.reference_write(now + 100'000, now) - (shown + 100'000); }
};

TEST(BusShift, AFrameThatLeftFarFromItsStampIsTakenBackAtOnce) {
  for (const bool known : {false, true}) {
    Settled bus;
    ASSERT_TRUE(bus.controller.state().in_sync);
    EXPECT_FALSE(bus.cycle(200, known).write_again);
    EXPECT_TRUE(bus.cycle(Settled::kLate, known).write_again) << known;
    // That frame told the clock 40 us too little; this one tells it as much too much.
    EXPECT_NEAR(bus.too_much(), Settled::kLate, 200) << known;
    bus.now += 100'000;
    bus.shown += 100'000;
    EXPECT_FALSE(bus.controller.observe_second_write(bus.observation(0, known)));
    EXPECT_NEAR(bus.too_much(), 0, 200) << "taken back once, not twice " << known;
  }
}

TEST(BusShift, ASecondWriteThatStraysIsTakenBackToo) {
  for (const bool known : {false, true}) {
    Settled bus;
    EXPECT_TRUE(bus.cycle(Settled::kLate, known).write_again);
    EXPECT_TRUE(bus.controller.observe_second_write(bus.observation(2 * Settled::kLate, known)));
    EXPECT_NEAR(bus.too_much(), 2 * Settled::kLate, 200) << known;
  }
}

/// A segment that answers the first frame after a pause later than those behind it.
TEST(BusShift, SecondWritesThatAreAlwaysQuickerThanTheFirstAreGivenUp) {
  Settled bus;
  int wanted = 0;
  for (int i = 0; i < 2'000; ++i) {
    if (!bus.cycle(55'000).write_again) continue;
    ++wanted;
    bus.now += 100'000;
    bus.shown += 100'000;
    (void)bus.controller.observe_second_write(bus.observation(0, false));
    bus.now -= 100'000;
    bus.shown -= 100'000;
  }
  EXPECT_LT(wanted, 100);
}

/// What a held frame may explain is no error, and no reason for a leap.
TEST(BusShift, HeldFramesMoveNeitherTheErrorNorWhatIsWritten) {
  Settled bus;
  const auto held = [&bus](Nanoseconds late) {
    bus.now += kMillisecond;
    bus.shown += kMillisecond;
    auto seen = bus.observation(late, false);
    seen.stamp_doubt = late + 500;
    (void)bus.controller.observe(seen);
  };
  for (const Nanoseconds late : {20'000, 600'000}) {
    for (int i = 0; i < 60; ++i) {
      held(late);
      EXPECT_NEAR(static_cast<double>(bus.controller.state().adjust), 0, 300) << late << " " << i;
      EXPECT_NEAR(static_cast<double>(bus.controller.state().error_filtered), 0, 300);
      EXPECT_TRUE(bus.controller.state().in_sync);
    }
    for (int i = 0; i < 100; ++i) bus.cycle(0);
  }
}

/// Behind a step nothing is learned of the drift while the clock comes back to its place; one that stays beyond the
/// limit is held there by what was learned before.
TEST(BusShift, AnErrorThatNoLongerGetsSmallerIsNotThatOfTheStep) {
  Settled bus;
  bus.shown += 30'000;
  for (int i = 0; i < 10; ++i) bus.cycle(0);
  ASSERT_FALSE(bus.controller.state().in_sync);
  const auto learned = bus.controller.state().output_sum;
  for (int i = 0; i < 1'000; ++i) {
    bus.shown -= 25;
    bus.cycle(0);
  }
  EXPECT_EQ(bus.controller.state().output_sum, learned) << "it comes back";
  for (int i = 0; i < 2'000; ++i) bus.cycle(0);
  EXPECT_LT(bus.controller.state().output_sum, learned - 100) << "it stays at 5 us";
}

TEST(BusShift, WritesTheTimeOfTheGridAtTheRealSendTime) {
  BusShift controller(settings_for(DcmMode::kBusShift), kMillisecond, 600'000);
  // SYNC0 at n ms, frames pass 600 us before: the nearest place of a clock that shows 5.450 ms is 5.400 ms.
  controller.start(0, 5'450'000, 1'000 * kMillisecond);
  EXPECT_EQ(controller.reference_write(1'000 * kMillisecond, 1'000 * kMillisecond), 5'400'000);
  EXPECT_EQ(controller.reference_write(1'002'000'300, 1'002'000'000), 7'400'300);
}

}  // namespace
}  // namespace syncline::dc
