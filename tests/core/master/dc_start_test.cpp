// SPDX-License-Identifier: Apache-2.0
// Start times of SYNC signals: who says them, and whether they will come.
#include "master/clocks/dc_start.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "channels/command.h"
#include "channels/event.h"
#include "channels/events/clock_events.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "master/master_service.h"
#include "tests/support/clock_bed.h"

namespace syncline {
namespace {

test::SimulatedNetwork line(std::size_t slaves) {
  test::SimulatedNetwork network;
  for (std::size_t i = 0; i < slaves; ++i) network.add(test::io8());
  return network;
}

/// A network that a MasterService runs on its own virtual clock.
class Running {
 public:
  explicit Running(const test::SimulatedNetwork& network) : config(network.compiled()) {
    auto made = sim::SimBus::create(network.sim, clock.now());
    bus = made->get();
    service = std::make_unique<MasterService>(make_simulated_link("sim", std::move(*made), clock), clock);
  }
  void run(Nanoseconds until) {
    service->channels().commands.push(GoOnlineCommand{config, AlState::kOp});
    service->run_for(until - clock.now());
    for (auto& event : service->channels().events.drain()) events.push_back(std::move(event));
    service->channels().snapshot.read(snapshot);
  }
  /// Phase of a slave's SYNC0 in a cycle of true time.
  [[nodiscard]] Nanoseconds phase(std::size_t slave, Nanoseconds now) {
    bus->advance_to(now);
    const auto next = load_le<std::uint64_t>(std::span<const std::uint8_t>(bus->peek(slave, 0x0990, 8)));
    const auto ahead = static_cast<Nanoseconds>(next - bus->system_time(slave));
    const auto cycle = config.cycle_time();
    return ((now + ahead) % cycle + cycle) % cycle;
  }
  [[nodiscard]] std::size_t count(EventKind kind) const {
    return static_cast<std::size_t>(std::ranges::count(events, kind, [](const Event& e) { return e.kind(); }));
  }

  VirtualClock clock;
  NetworkConfig config;
  sim::SimBus* bus = nullptr;
  std::unique_ptr<MasterService> service;
  std::vector<Event> events;
  Snapshot snapshot;
};

TEST(DcStart, CallbackIsAskedForEverySlaveAndItsTimeIsPassedOnWithTheShiftOnly) {
  auto network = line(3);
  network.project.slaves[2].dc.sync0.shift = 100 * kMicrosecond;
  Running running(network);
  std::vector<std::uint16_t> asked;
  Nanoseconds start = 0;
  running.service->set_dc_start_time([&](std::uint16_t station) -> std::optional<Nanoseconds> {
    asked.push_back(station);
    if (start == 0) start = (running.clock.now() / kMillisecond + 50) * kMillisecond + 123'450;
    return start;
  });
  const auto end = running.clock.now() + 8 * kSecond;
  running.run(end);
  EXPECT_EQ(running.snapshot.state, AlState::kOp);
  std::ranges::sort(asked);
  const auto last = std::unique(asked.begin(), asked.end());
  EXPECT_EQ(std::vector(asked.begin(), last), (std::vector<std::uint16_t>{1001, 1002, 1003}));
  const auto system_phase = [&](std::size_t i) {
    return load_le<std::uint64_t>(std::span<const std::uint8_t>(running.bus->peek(i, 0x0990, 8))) % kMillisecond;
  };
  EXPECT_EQ(system_phase(0), 123'450U);
  EXPECT_EQ(system_phase(1), 123'450U);
  EXPECT_EQ(system_phase(2), 223'450U);
}

void find_passed_start_times(bool wide) {
  auto network = line(3);
  for (auto& slave : network.sim.slaves) slave.dc.is_64bit = wide;
  test::ClockBed bed(network);
  ASSERT_TRUE(bed.set_up());
  const auto activate = [&](std::size_t slave, std::uint64_t start) {
    const auto station = bed.config().slaves[slave].station_address;
    ASSERT_TRUE(bed.access().write(Command::kFpwr, station, reg::kSync0CycleTime, std::uint32_t{1'000'000}));
    ASSERT_TRUE(bed.access().write(Command::kFpwr, station, reg::kStartTimeCyclicOperation, start));
    ASSERT_TRUE(bed.access().write(Command::kFpwr, station, reg::kCyclicUnitControl, std::uint16_t{0x0300}));
  };
  const auto start = bed.clock.now() + 5 * kMillisecond;
  activate(0, static_cast<std::uint64_t>(start));
  activate(1, static_cast<std::uint64_t>(bed.clock.now() - 5 * kMillisecond));
  const std::array<std::size_t, 3> all{0, 1, 2};
  const auto readings = read_dc_start(bed.access(), bed.config(), all);
  ASSERT_TRUE(readings);
  ASSERT_EQ(readings->size(), 3U);
  EXPECT_FALSE((*readings)[0].error);
  ASSERT_TRUE((*readings)[0].next);
  constexpr Nanoseconds kLowWord = 0xFFFF'FFFF;
  EXPECT_EQ(*(*readings)[0].next & kLowWord, start & kLowWord);
  ASSERT_TRUE((*readings)[1].error);
  EXPECT_NE((*readings)[1].error->subject.find("slave 1"), std::string::npos);
  EXPECT_THAT((*readings)[1].error->detail.text(), testing::ContainsRegex("will never come.*by [567]...... ns"));
  ASSERT_TRUE((*readings)[2].error) << "nobody activated it";
  EXPECT_NE((*readings)[2].error->subject.find("slave 2"), std::string::npos);
  EXPECT_NE((*readings)[2].error->detail.text().find("not active"), std::string::npos);
}

TEST(DcStart, StartTimeThatHasPassedIsFoundByReadingBack) {
  for (const bool wide : {true, false}) {
    SCOPED_TRACE(wide);
    find_passed_start_times(wide);
  }
}

TEST(DcStart, Sync0IsOffItsGridByWhatTheSlaveTookOtherwise) {
  NetworkConfig config;
  SlaveDcConfig dc;
  dc.cycle_time0 = 500'000;
  dc.shift_time = 30'000;
  const Nanoseconds base = 7 * kSecond + 123, now = 20 * kSecond;
  const Nanoseconds placed = base + dc.shift_time + Nanoseconds{27'000} * dc.cycle_time0;
  EXPECT_EQ(sync0_off_grid(config, dc, placed, base, now), 0);
  EXPECT_EQ(sync0_off_grid(config, dc, placed + 40'000, base, now), 40'000);
  EXPECT_EQ(sync0_off_grid(config, dc, placed - 40'000, base, now), -40'000);
  EXPECT_EQ(sync0_off_grid(config, dc, (placed + 40'000) & 0xFFFFFFFF, base, now), 40'000) << "a clock of 32 bits";
}

TEST(DcStart, TheTimeUntilActiveFollowsTheStepsThatWereSeen) {
  const auto list = line(1).compiled().slaves[0].init_cmds;
  std::vector<const InitCmd*> commands;
  for (const auto& command : list) {
    if (std::ranges::find(command.transitions, Transition::kPS) != command.transitions.end())
      commands.push_back(&command);
  }
  auto pace = dc_start_pace(commands);
  ASSERT_GT(pace.steps_before, 0U);
  EXPECT_EQ(pace.steps_until, 1U) << "the activation follows at once";
  const auto steps = static_cast<Nanoseconds>(pace.steps_before);
  const auto time = time_until_active(pace, steps * 20 * kMillisecond, kMillisecond);
  EXPECT_EQ(time, 3 * 20 * kMillisecond) << "start time, activation, and one that is repeated";
  pace.attempt = 2;
  EXPECT_EQ(time_until_active(pace, steps * 20 * kMillisecond, kMillisecond), 4 * time);
  const DcStartPace unknown{1000, 0, 1, 0};
  EXPECT_GE(time_until_active(unknown, 0, kMillisecond), 3 * 17 * kMillisecond) << "24,000 bytes, a frame a cycle";
}

TEST(DcStart, AStartTimeThatCameTooLateIsGivenAgain) {
  Running running(line(3));
  std::vector<std::uint16_t> asked;
  running.service->set_dc_start_time([&](std::uint16_t station) -> std::optional<Nanoseconds> {
    const bool first = std::ranges::find(asked, station) == asked.end();
    asked.push_back(station);
    return first && station != 1001 ? std::optional(running.clock.now() - kMillisecond) : std::nullopt;
  });
  running.run(running.clock.now() + 8 * kSecond);
  EXPECT_EQ(running.snapshot.state, AlState::kOp);
  EXPECT_EQ(running.count(kind_of<events::Failure>), 0U);
  EXPECT_EQ(std::ranges::count(asked, 1001), 1) << "who was in time is left alone";
  EXPECT_EQ(std::ranges::count(asked, 1002), 2);
}

TEST(DcStart, CallbackThatNamesAPastTimeKeepsTheSlaveFromOpWithItsName) {
  Running running(line(2));
  running.service->set_dc_start_time([&](std::uint16_t station) -> std::optional<Nanoseconds> {
    if (station == 1001) return std::nullopt;
    return running.clock.now() - kSecond;
  });
  running.run(running.clock.now() + 8 * kSecond);
  EXPECT_NE(running.snapshot.state, AlState::kOp);
  const bool named = std::ranges::any_of(running.events, [](const Event& event) {
    const auto* failure = event.as<events::Failure>();
    return (failure != nullptr && failure->error.subject.find("slave 1") != std::string::npos) || event.slave == 1;
  });
  EXPECT_TRUE(named);
}

TEST(DcStart, NetworksOfOneHostAreInPhaseThroughTheGrid) {
  // Two segments of different sizes and quartzes; they share nothing but the host's clock.
  const auto spread = [](Nanoseconds grid) {
    auto first = line(3), second = line(7);
    for (auto& slave : second.sim.slaves) slave.oscillator.ppm -= 30;
    first.project.master.dc.start_time_grid = second.project.master.dc.start_time_grid = grid;
    Running one(first), two(second);
    EXPECT_EQ(one.clock.now(), two.clock.now());
    const auto end = one.clock.now() + 12 * kSecond;
    one.run(end);
    two.run(end);
    EXPECT_EQ(one.snapshot.state, AlState::kOp);
    EXPECT_EQ(two.snapshot.state, AlState::kOp);
    const auto now = end + 20 * kMillisecond;
    const auto origin = one.phase(0, now);
    Nanoseconds low = 0, high = 0;
    const auto look = [&](Running& network) {
      for (std::size_t i = 0; i < network.config.slaves.size(); ++i) {
        auto away = network.phase(i, now) - origin;
        if (away > kMillisecond / 2) away -= kMillisecond;
        if (away < -kMillisecond / 2) away += kMillisecond;
        low = std::min(low, away);
        high = std::max(high, away);
      }
    };
    look(one);
    look(two);
    return high - low;
  };
  EXPECT_LT(spread(kMillisecond), kMicrosecond);
  EXPECT_GT(spread(0), kMicrosecond);  // each starts where it happens to
}

constexpr EventKind kOfTheClocks[] = {kind_of<events::ReferenceClockChanged>, kind_of<events::SlavesInSync>,
                                      kind_of<events::DcInitialised>, kind_of<events::MasterInSync>};

TEST(DcNotifications, AreToldUnlessSwitchedOff) {
  auto network = line(3);
  network.project.master.dc.sync_window.enabled = true;
  Running all(network);
  all.run(all.clock.now() + 6 * kSecond);
  for (const auto kind : kOfTheClocks) {
    EXPECT_EQ(all.count(kind), 1U);
  }
  network.project.master.dc.notifications = {false, false, false, false};
  Running none(network);
  none.run(none.clock.now() + 6 * kSecond);
  EXPECT_EQ(none.snapshot.state, AlState::kOp);
  for (const auto kind : kOfTheClocks) {
    EXPECT_EQ(none.count(kind), 0U);
  }
}

TEST(DcSyncWindow, NamesTheSlaveThatLeftItAmongMany) {
  auto network = line(60);
  network.project.master.dc.sync_window.enabled = true;
  network.project.master.dc.dcm.mode = DcmMode::kMasterShift;
  FaultConfig step;
  step.kind = FaultKind::kClockStep;
  step.slave = 41;
  step.at = 6 * kSecond;
  step.value_ns = 5'000;
  network.sim.faults.push_back(step);
  Running running(network);
  running.run(running.clock.now() + 8 * kSecond);
  const auto out =
      std::ranges::find_if(running.events, [](const Event& event) { return event.is<events::SlavesOutOfSync>(); });
  ASSERT_NE(out, running.events.end());
  EXPECT_EQ(out->slave, 41);
  EXPECT_GT(out->as<events::SlavesOutOfSync>()->deviation_ns, 127);
}

TEST(DcSystemTime, Travels4Or8BytesAsConfigured) {
  for (const bool wide : {false, true}) {
    auto network = line(3);
    network.project.master.dc.show_64bit_system_time = wide;
    network.project.master.dc.sync_window.enabled = true;
    Running running(network);
    bool found = false;
    for (const auto& frame : running.config.cyclic.front().frames) {
      for (const auto& command : frame.commands) {
        if (command.command != Command::kArmw) continue;
        found = true;
        EXPECT_EQ(command.length(), wide ? 8 : 4);
      }
    }
    EXPECT_TRUE(found);
    running.run(running.clock.now() + 6 * kSecond);
    EXPECT_EQ(running.snapshot.state, AlState::kOp) << wide;
    EXPECT_EQ(running.snapshot.dc.state, SyncState::kInSync) << wide;
  }
}

}  // namespace
}  // namespace syncline
