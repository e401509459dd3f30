// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "master/master_service.h"
#include "protocol/al_state.h"
#include "tests/support/event_match.h"
#include "tests/support/own_devices.h"
#include "tests/support/sample_devices.h"
#include "tests/support/simulated_segment.h"

namespace syncline::test {

/// A coupler and two servo drives on the simulated bus, taken online by a MasterService. The drives do not fall for
/// missed SM2 events. The bus is made when it is needed first: until then a test changes devices, project and faults.
class OperationBed : public ::testing::Test {
 protected:
  /// Of faults, since the bus was switched on: when every bring-up is over.
  static constexpr Nanoseconds kLater = 20 * kSecond;

  VirtualClock clock;
  SimulatedNetwork network;
  SimulatedSegment* link = nullptr;
  std::unique_ptr<MasterService> service;
  NetworkConfig config;
  std::vector<Event> events;
  std::vector<CycleSample> samples;
  Snapshot snapshot;

  void SetUp() override {
    network.add(sample::own("SL-1100"));
    for (int i = 0; i < 2; ++i) network.add(sample::own("SL-SV7"), "servo-y");
    // A drive's cable is at port C of the coupler, whose port B is an E-bus.
    network.sim.slaves[1].parent_port = 2;
    network.project.slaves[1].previous = PreviousPort{0, 2};
    network.sim.slaves[0].dc.system_time = false;
    auto& project = network.project;
    for (const std::size_t drive : {1U, 2U}) {
      StartupCommand no_limit;
      no_limit.index = 0x10F1;
      no_limit.sub_index = 2;
      no_limit.data = {0, 0};
      project.slaves[drive].startup.push_back(no_limit);
    }
    project.master.dc.reference_clock = 1;
    project.master.dc.burst_total = 5000;
  }

  FaultConfig& fault(FaultKind kind, int slave, Nanoseconds at = kLater) {
    auto& made = network.sim.faults.emplace_back();
    made.kind = kind;
    made.slave = slave;
    made.at = at;
    return made;
  }
  void make_service() {
    if (service) return;
    config = network.compiled();
    ASSERT_EQ(config.slaves.size(), network.project.slaves.size());
    auto segment = std::make_unique<SimulatedSegment>(clock, network.sim);
    link = segment.get();
    begin_ = clock.now();
    service = std::make_unique<MasterService>(std::move(segment), clock);
  }
  void go_online(AlState target = AlState::kOp) {
    make_service();
    service->channels().commands.push(GoOnlineCommand{config, target});
    ASSERT_TRUE(service->step());
    drain();
  }
  void go_offline() {
    service->channels().commands.push(GoOfflineCommand{});
    while (service->online() && service->step()) {
    }
    drain();
  }
  void drain() {
    for (auto& event : service->channels().events.drain()) events.push_back(std::move(event));
    service->channels().samples.pop(samples);
    service->channels().snapshot.read(snapshot);
  }
  void run(Nanoseconds duration) {
    service->run_for(duration);
    drain();
  }
  /// Until so long after the bus was switched on.
  void run_until(Nanoseconds time) { run(begin_ + time - clock.now()); }
  /// A state that was asked for may take a drive's PLL and its master's patience.
  void run_to(AlState state) {
    for (int i = 0; i < 100 && snapshot.state != state; ++i) run(100 * kMillisecond);
  }

  [[nodiscard]] std::uint16_t al_status(std::size_t position) const {
    return link->get<std::uint16_t>(position, reg::kAlStatus);
  }
  [[nodiscard]] std::optional<Error> first_error() const {
    for (const auto& event : events) {
      if (const auto* failure = event.as<events::Failure>()) return failure->error;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::size_t count(EventKind kind) const {
    return static_cast<std::size_t>(std::ranges::count(events, kind, [](const Event& e) { return e.kind(); }));
  }
  /// Over the counts in all events of a kind.
  template <class What>
  [[nodiscard]] std::int64_t sum() const {
    std::int64_t total = 0;
    for (const auto& event : events) {
      if (const auto* what = event.as<What>()) total += what->count;
    }
    return total;
  }
  [[nodiscard]] Nanoseconds time_of(EventKind kind) const {
    const auto found = std::ranges::find(events, kind, [](const Event& e) { return e.kind(); });
    return found == events.end() ? -1 : found->time;
  }
  [[nodiscard]] Nanoseconds time_of_state(AlState state) const {
    for (const auto& event : events) {
      if (event.slave < 0 && with(&events::StateChanged::to, state)(event)) return event.time;
    }
    return -1;
  }
  /// States that the slave was asked for, in order; of the frames that were recorded.
  [[nodiscard]] std::vector<AlState> requests_to(std::size_t position) const {
    std::vector<AlState> states;
    for (auto frame : link->sent) {
      FrameReader reader(frame);
      while (const auto datagram = reader.next()) {
        const auto& header = datagram->header;
        const bool all = header.command == Command::kBwr;
        const bool one = header.command == Command::kFpwr && header.adp() == config.slaves[position].station_address;
        if ((all || one) && header.ado() == reg::kAlControl) states.push_back(al_state_of(datagram->data[0]));
      }
    }
    return states;
  }

 private:
  Nanoseconds begin_ = 0;
};

}  // namespace syncline::test
