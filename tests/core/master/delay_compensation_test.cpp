// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/delay_compensation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "channels/master_channels.h"
#include "master/exchange/run_state.h"
#include "protocol/system_time_difference.h"
#include "tests/support/clock_bed.h"

namespace syncline {
namespace {

/// Five terminals in a line, cycled by hand.
class DelayCompensationTest : public ::testing::Test {
 protected:
  static constexpr std::size_t kSlaves = 5;
  static test::SimulatedNetwork line() {
    test::SimulatedNetwork network;
    for (std::size_t i = 0; i < kSlaves; ++i) {
      network.add(test::io8());
      network.sim.slaves.back().cable_m = 20;
    }
    network.project.master.dc.continuous_propagation_compensation = true;
    network.project.master.dc.dcm.mode = DcmMode::kMasterShift;
    return network;
  }
  void SetUp() override {
    auto result = bed.set_up();
    ASSERT_TRUE(result);
    network = std::move(*result);
    for (std::size_t i = 0; i < kSlaves; ++i) {
      run.snapshot.slaves[i].present = true;
      run.snapshot.slaves[i].dc_enabled = true;
    }
  }
  /// As if it had been measured wrong, or re-plugged since.
  void set_delay(std::size_t slave, std::uint32_t delay) {
    network.slaves[slave].delay_ns = delay;
    const auto station = bed.config().slaves[slave].station_address;
    ASSERT_TRUE(bed.access().write(Command::kFpwr, station, reg::kSystemTimeDelay, delay));
  }
  [[nodiscard]] std::uint32_t delay_register(std::size_t slave) const {
    return load_le<std::uint32_t>(std::span<const std::uint8_t>(bed.bus().peek(slave, reg::kSystemTimeDelay, 4)));
  }
  [[nodiscard]] std::uint32_t truth(std::size_t slave) const {
    return static_cast<std::uint32_t>(std::llround(bed.bus().true_delay_ns(slave) - bed.bus().true_delay_ns(0)));
  }
  /// Bus cycles with nothing but the time and what is asked for; the largest deviation that a slave shows meanwhile.
  std::uint32_t cycle_for(Nanoseconds duration) {
    const auto end = bed.clock.now() + duration;
    auto next = bed.clock.now();
    std::array<std::uint8_t, 4> time{};
    Datagram armw{Command::kArmw, device_address(0, reg::kSystemTime), time};
    std::array<PendingFrame, 3> frames;
    std::uint32_t largest = 0;
    while (bed.clock.now() < end) {
      next += kMillisecond;
      bed.clock.sleep_until(next);
      std::size_t used = 0;
      for (auto& frame : frames) frame.clear();
      time.fill(0);
      (void)frames[0].add(armw);
      for (auto* request : compensation.requests(bed.clock.now())) {
        while (used < frames.size() && !frames[used].add(*request)) ++used;
      }
      std::vector<PendingFrame*> in_flight;
      for (auto& frame : frames) {
        if (frame.empty()) continue;
        EXPECT_TRUE(bed.access().exchange().send(frame));
        in_flight.push_back(&frame);
      }
      EXPECT_TRUE(bed.access().exchange().collect(in_flight, bed.clock.now() + kMillisecond / 2));
      compensation.take(bed.clock.now(), leader);
      for (std::size_t i = 1; i < kSlaves; ++i) {
        const auto bytes = bed.bus().peek(i, reg::kSystemTimeDifference, 4);
        largest = std::max(largest, SystemTimeDifference{load_le<std::uint32_t>(std::span(bytes))}.magnitude());
      }
    }
    return largest;
  }
  std::vector<Event> measured() {
    auto events = channels.events.drain();
    std::erase_if(events, [](const Event& event) { return !event.is<events::DelaysMeasured>(); });
    return events;
  }

  test::ClockBed bed{line()};
  DcNetwork network;
  MasterChannels channels;
  RunState run{bed.config(), channels};
  DelayCompensation compensation{bed.config(), run.snapshot, run.states, run.teller};
  std::optional<std::uint16_t> leader = 0;
};

TEST_F(DelayCompensationTest, CorrectsAWrongDelayWithoutAStepOfTheClocks) {
  set_delay(3, truth(3) + 150);
  compensation.start(network, bed.clock.now());
  (void)cycle_for(2 * kSecond);  // the wrong delay itself is learned
  const auto largest = cycle_for(60 * kSecond);
  EXPECT_NEAR(static_cast<double>(delay_register(3)), truth(3), 20);
  EXPECT_LT(largest, 45U);  // the noise of the stamps, and never 150
  EXPECT_EQ(run.snapshot.slaves[3].propagation_delay_ns, delay_register(3));
  const auto events = measured();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].as<events::DelaysMeasured>()->corrected, 1U);
  EXPECT_NEAR(static_cast<double>(events[0].as<events::DelaysMeasured>()->largest_ns), -150, 20);
  EXPECT_EQ(events[1].as<events::DelaysMeasured>()->corrected, 0U);
}

TEST_F(DelayCompensationTest, LeavesTheNoiseOfTheStampsAlone) {
  set_delay(2, network.slaves[2].delay_ns + 15);
  compensation.start(network, bed.clock.now());
  (void)cycle_for(62 * kSecond);
  for (std::size_t i = 0; i < kSlaves; ++i) EXPECT_EQ(delay_register(i), network.slaves[i].delay_ns);
  EXPECT_EQ(measured().size(), 2U);
}

TEST_F(DelayCompensationTest, IsSwitchedWhileTheBusRuns) {
  set_delay(3, truth(3) + 150);
  compensation.start(network, bed.clock.now());
  compensation.set_enabled(false, bed.clock.now());
  (void)cycle_for(40 * kSecond);
  EXPECT_EQ(delay_register(3), truth(3) + 150);
  compensation.set_enabled(true, bed.clock.now());
  (void)cycle_for(35 * kSecond);
  EXPECT_LT(delay_register(3), truth(3) + 150);
  compensation.set_enabled(false, bed.clock.now());
  const auto half_way = delay_register(3);
  (void)cycle_for(10 * kSecond);
  EXPECT_EQ(delay_register(3), half_way);
}

TEST_F(DelayCompensationTest, SaysNothingWhileASlaveIsMissingOrAnotherClockLeads) {
  set_delay(3, truth(3) + 150);
  compensation.start(network, bed.clock.now());
  run.snapshot.slaves[4].present = false;
  (void)cycle_for(35 * kSecond);
  run.snapshot.slaves[4].present = true;
  leader = 1;
  (void)cycle_for(35 * kSecond);
  EXPECT_EQ(delay_register(3), truth(3) + 150);
  EXPECT_TRUE(measured().empty());
}

TEST_F(DelayCompensationTest, TakesAnImplausibleChangeForAnotherSegment) {
  set_delay(3, truth(3) + 20'000);
  compensation.start(network, bed.clock.now());
  (void)cycle_for(35 * kSecond);
  EXPECT_EQ(delay_register(3), truth(3) + 20'000);
}

}  // namespace
}  // namespace syncline
