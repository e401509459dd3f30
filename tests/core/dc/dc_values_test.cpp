// SPDX-License-Identifier: Apache-2.0
// Values that the longer runs of the other tests do not tell from their neighbours.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "dc/clock_registers.h"
#include "dc/dcm/bus_cycle_check.h"
#include "dc/dcm/bus_shift.h"
#include "dc/dcm/drift_estimator.h"
#include "dc/dcm/master_shift.h"
#include "dc/dcm/written_clock.h"
#include "dc/outlier_gate.h"
#include "dc/propagation_delay.h"
#include "dcm_plant.h"

namespace syncline::dc {
namespace {

TEST(SpeedCounterStart, IsTheRootOfTheCycleWithinWhatTheRegisterTakes) {
  EXPECT_EQ(speed_counter_start(kMillisecond), 1'000);
  EXPECT_EQ(speed_counter_start(4 * kMillisecond), 2'000);
  EXPECT_EQ(speed_counter_start(50'000), 0x0100);
  EXPECT_EQ(speed_counter_start(kSecond), 0x3FFF);
  EXPECT_EQ(speed_counter_start(-1), 0x0100);
}

/// Where every second reading is one, each widens the scatter by half a hundredth of what that lacks to the gate, and
/// each other takes two hundredths of it: 1.25 % more gate for each two of them, until 20 us are within it.
TEST(OutlierGate, OpensByWhatItLacks) {
  OutlierGate gate(3'000);
  int outliers = 0;
  for (int i = 0; i < 2'000; ++i) {
    if (gate.judge(i % 2 == 0 ? 20'000 : 0, true) == OutlierGate::Verdict::kOutlier) ++outliers;
  }
  const double growing = std::log(20.0 / 3.0) / std::log(1.0125);
  EXPECT_GT(outliers, growing);
  EXPECT_LT(outliers, growing + 80) << "and what the first 400 ns of scatter take";
}

/// A cycle that was left out, while the schedule is moved.
TEST(MasterShift, CountsTheCyclesThatPassedToTheNearest) {
  MasterShift controller(settings_for(DcmMode::kMasterShift), kMillisecond, 600'000);
  controller.start(0, 5'400'000, 0);
  constexpr double kRate = 1 - 500e-6;  // of the reference clock: the schedule is moved by 500 ns a cycle
  Nanoseconds time = 0;
  const auto observe = [&] {
    return controller.observe({time, time, 5'400'000 + std::llround(static_cast<double>(time) * kRate)}).period_adjust;
  };
  for (int i = 0; i < 4'000; ++i) time += kMillisecond + observe();
  ASSERT_TRUE(controller.state().in_sync);
  for (const int cycles : {2, 3}) {
    const auto learned = controller.state().output_sum;
    time += cycles * kMillisecond - 300;
    (void)observe();
    // Sent early by that and by what nobody moved the schedule meanwhile; a tenth of it is taken back at once.
    const double early = 300 + 500 * cycles;
    EXPECT_NEAR(controller.state().output_sum, learned, 5) << cycles;
    EXPECT_NEAR(static_cast<double>(controller.state().adjust), learned + early / 10, 20) << cycles;
    for (int i = 0; i < 500; ++i) time += kMillisecond + observe();
  }
}

TEST(DriftEstimator, SaysWhenABlockIsNewAndOnlyThen) {
  DriftEstimator drift;
  int told = 0;
  Nanoseconds first = 0, last = 0;
  for (Nanoseconds time = 0; time < 4 * kSecond; time += kMillisecond) {
    if (!drift.observe(time, time + time / 20'000)) continue;
    if (told++ == 0) first = time;
    last = time;
  }
  ASSERT_GT(told, 4);
  const double block = static_cast<double>(last - first) / (told - 1);
  EXPECT_GT(block, 50.0 * kMillisecond) << "not in each cycle";
  EXPECT_NEAR(static_cast<double>(first), 2 * block, block / 2) << "a rate takes two of them";
  ASSERT_TRUE(drift.half_width_ppm());
  EXPECT_GT(*drift.half_width_ppm(), 0) << "times are whole nanoseconds";
  EXPECT_LT(*drift.half_width_ppm(), 0.01);
}

/// Nothing of the clock before is written to the one after.
TEST(BusShift, BegunAnewForecastsNothing) {
  BusShift controller(settings_for(DcmMode::kBusShift), kMillisecond, 600'000);
  controller.start(0, 5'400'000, 0);
  for (Nanoseconds time = 0; time < kSecond; time += kMillisecond) {
    (void)controller.reference_write(time, time);
    (void)controller.observe({time, time, 5'400'000 + time + 250'000});
  }
  controller.start(0, 905'400'000, 2 * kSecond);
  EXPECT_EQ(controller.reference_write(2 * kSecond, 2 * kSecond), 905'400'000);
}

/// A second of a wrong period was of the run before.
TEST(MasterShift, BegunAnewKnowsNoWrongCycle) {
  MasterShift controller(settings_for(DcmMode::kMasterShift), kMillisecond, 600'000);
  controller.start(0, 5'400'000, 0);
  Nanoseconds time = 0;
  for (; time < 3 * kSecond; time += kMillisecond * 11 / 10) (void)controller.observe({time, time, 5'400'000 + time});
  ASSERT_NE(controller.state().error_code, 0U);
  controller.start(0, 5'400'000 + time, time);
  (void)controller.observe({time, time, 5'400'000 + time});
  EXPECT_EQ(controller.state().error_code, 0U);
}

/// Of few and long cycles one more or less would hide or make what is looked for.
TEST(BusCycleCheck, CountsEachCycleOnce) {
  for (const bool wrong : {true, false}) {
    BusCycleCheck check(20 * kMillisecond);
    const Nanoseconds period = (wrong ? 20'500 : 20'350) * kMicrosecond;  // 2.5 and 1.75 %
    for (int window = 0; window < 3; ++window) {
      for (int i = 0; i < 65; ++i) check.observe((window * 65 + i) * period, true);
      EXPECT_EQ(check.wrong(), wrong) << window;
    }
  }
}

/// What the clock lags by as a rule is none of the way's.
TEST(WrittenClock, MovesByWhatTheWayHasChanged) {
  for (const Nanoseconds jump : {120, -120}) {
    WrittenClock controller(WrittenClock::Time::kOfSending, settings_for(DcmMode::kLinkLayerRefClock), kMillisecond,
                            600'000, 0);
    controller.start(0, 5'400'000, 0);
    Nanoseconds time = 0;
    for (; time < 3 * kSecond; time += kMillisecond)
      EXPECT_FALSE(controller.observe({time, time, 5'400'000 + time + 40}).write_again);
    ASSERT_TRUE(controller.state().in_sync);
    const auto before = controller.reference_write(time, time);
    EXPECT_TRUE(controller.observe({time, time, 5'400'000 + time + 40 + jump}).write_again);
    const auto after = controller.reference_write(time, time);
    ASSERT_TRUE(before && after);
    EXPECT_EQ(*after - *before, jump);
    EXPECT_EQ(controller.state().error, 40) << "it is where it was";
  }
}

/// Entered by port 1 with port 0 closed: only 0x0918 tells how far it is to the processing unit, where it tells that.
TEST(PropagationDelay, TheWayToTheProcessingUnitIsOneForward) {
  const auto delay = [](std::uint32_t processed) {
    DelayNode first, second;
    first.kind = second.kind = DcKind::kFull;
    first.active[0] = first.active[1] = true;
    first.receive_time = {1'000, 2'000, 0, 0};
    second.parent = 0;
    second.parent_port = 1;
    second.active[1] = true;
    second.receive_time = {0, 50'000, 0, 0};
    second.processing_time = processed;
    const std::vector nodes{first, second};
    return propagation_delays(nodes, {.t_diff_ns = 0}).delay_ns[1];
  };
  EXPECT_EQ(delay(50'300), 800U);
  EXPECT_EQ(delay(49'900), 500U) << "before it came in";
  EXPECT_EQ(delay(50'000 + 100'000'001), 500U) << "longer than any segment";
}

}  // namespace
}  // namespace syncline::dc
