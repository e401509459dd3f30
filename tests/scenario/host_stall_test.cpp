// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "link/simulated_host.h"
#include "link/simulated_link.h"
#include "master/master_service.h"
#include "protocol/frame.h"
#include "tests/support/simulated_network.h"

namespace syncline {
namespace {

FaultConfig stall(Nanoseconds at, Nanoseconds length) {
  FaultConfig fault;
  fault.kind = FaultKind::kHostStall;
  fault.at = at;
  fault.value_ns = length;
  return fault;
}

test::SimulatedNetwork two_axes() {
  test::SimulatedNetwork network;
  network.add(test::io8());
  network.add(test::servo(), "servo-y");
  network.add(test::servo(), "servo-y");
  return network;
}

TEST(HostStall, LeavesCyclesOutAndLosesNoFrame) {
  VirtualClock clock;
  auto network = two_axes();
  network.sim.faults = {stall(8 * kSecond, 35 * kMillisecond)};
  const auto start = clock.now();
  MasterService service(network.link(clock), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  std::vector<CycleSample> samples;
  while (clock.now() < start + 9 * kSecond) {
    service.run_for(100 * kMillisecond);
    service.channels().samples.pop(samples);
  }
  Nanoseconds longest = 0, after = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto gap = samples[i].send_time - samples[i - 1].send_time;
    if (gap > longest) longest = gap, after = samples[i].send_time - start;
  }
  EXPECT_GE(longest, 34 * kMillisecond);
  EXPECT_LE(longest, 37 * kMillisecond);
  EXPECT_GE(after, 8 * kSecond + 35 * kMillisecond);
  EXPECT_LE(after, 8 * kSecond + 36 * kMillisecond);
  Snapshot snapshot;
  service.channels().snapshot.read(snapshot);
  EXPECT_GT(snapshot.overruns, 0U);
  EXPECT_EQ(snapshot.lost_frames, 0U);
}

/// A frame that is on its way when the host stops is received when it goes on, with the time at which it arrived.
TEST(HostStall, FramesInFlightAreReceivedLate) {
  VirtualClock clock;
  auto network = two_axes();
  network.sim.faults = {stall(kMillisecond, 5 * kMillisecond)};
  const auto start = clock.now();
  const auto link = network.link(clock);
  FrameBuilder builder;
  builder.add(Command::kBrd, 1, 0x0130, std::vector<std::uint8_t>(2));
  std::array<std::uint8_t, 1514> buffer{};
  clock.advance_to(start + kMillisecond - 2 * kMicrosecond);
  ASSERT_TRUE(link->send(builder.finish()));
  const auto received = link->receive(buffer, clock.now() + 100);  // shorter than the frame takes
  ASSERT_TRUE(received);
  EXPECT_EQ(received->length, 0U);
  const auto later = link->receive(buffer, start + kMillisecond);  // ... and now the host stands still
  ASSERT_TRUE(later);
  EXPECT_GT(later->length, 0U);
  EXPECT_LT(later->arrival_time, start + kMillisecond + 50 * kMicrosecond);
  EXPECT_EQ(clock.now(), start + 6 * kMillisecond);
}

/// What a host of many short stalls sees of its frames, in whose midst its calendar is set or not.
struct SeenByHost {
  std::vector<std::array<Nanoseconds, 4>> cycles;
  std::vector<std::size_t> events;
  bool operator==(const SeenByHost&) const = default;
};

SeenByHost seen_by_host(bool set_calendar) {
  VirtualClock clock;
  auto network = two_axes();
  constexpr std::array<Nanoseconds, 5> kBy{3 * kMillisecond, -3 * kMillisecond, 250 * kMillisecond, -250 * kMillisecond,
                                           5 * kSecond};
  for (std::size_t i = 0; i < 100; ++i) {
    const auto at = 4 * kSecond + static_cast<Nanoseconds>(i) * 37'013 * kMicrosecond;
    network.sim.faults.push_back(stall(at, 300 * kMicrosecond));
    if (!set_calendar) continue;
    FaultConfig step;
    step.kind = FaultKind::kCalendarStep;
    step.at = at + 150 * kMicrosecond;
    step.value_ns = kBy[i % kBy.size()];
    network.sim.faults.push_back(step);
  }
  const auto config = network.compiled();
  auto bus = sim::SimBus::create(network.sim, clock.now());
  EXPECT_TRUE(bus);
  const auto host = set_up_host(clock, network.sim);
  MasterService service(make_simulated_link("sim", std::move(*bus), clock, host), clock);
  service.channels().commands.push(GoOnlineCommand{config, AlState::kOp});
  SeenByHost seen;
  std::vector<CycleSample> samples;
  for (const auto end = clock.now() + 9 * kSecond; clock.now() < end;) {
    service.run_for(100 * kMillisecond);
    service.channels().samples.pop(samples);
    for (const auto& event : service.channels().events.drain()) seen.events.push_back(event.what.index());
  }
  for (const auto& s : samples) seen.cycles.push_back({s.send_time, s.round_trip_ns, s.dcm_error_ns, s.late_by_ns});
  return seen;
}

/// Frames that came while the host stood still were stamped by the calendar as it was then.
TEST(CalendarStep, ChangesNothingOfWhatTheHostSees) {
  const auto as_it_is = seen_by_host(false);
  EXPECT_GT(as_it_is.cycles.size(), 7'000U);
  EXPECT_TRUE(seen_by_host(true) == as_it_is);
}

}  // namespace
}  // namespace syncline
