// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/cli/event_text.h"
#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/master_channels.h"
#include "link/link.h"
#include "master/master_service.h"
#include "support/clock.h"
#include "tests/support/simulated_network.h"
#include "trace/run_report.h"

namespace syncline::test {

/// A simulated machine that is brought to OP and runs on the virtual clock, with all that is told of it.
class MachineRun : public ::testing::Test {
 protected:
  VirtualClock clock;
  SimulatedNetwork network;
  std::unique_ptr<MasterService> service;
  std::unique_ptr<RunRecorder> recorder;
  std::vector<Event> events;
  std::vector<CycleSample> samples;
  Snapshot snapshot;
  Nanoseconds start = 0;

  /// Times from when the segment is made.
  FaultConfig& fault(FaultKind kind, int slave, Nanoseconds at, Nanoseconds until = 0, std::uint32_t count = 1) {
    FaultConfig fault;
    fault.kind = kind;
    fault.slave = slave;
    fault.at = at;
    fault.until = until;
    fault.count = count;
    network.sim.faults.push_back(fault);
    return network.sim.faults.back();
  }
  /// The way to the segment, over the host that the machine says. Null: it cannot be made.
  [[nodiscard]] virtual std::unique_ptr<Link> make_link() {
    const auto host = set_up_host(clock, network.sim);
    auto bus = sim::SimBus::create(network.sim, clock.now());
    return bus ? make_simulated_link("sim", std::move(*bus), clock, host) : nullptr;
  }
  void go_online() {
    events.clear();
    samples.clear();
    snapshot = {};
    start = clock.now();
    auto link = make_link();
    ASSERT_TRUE(link);
    service = std::make_unique<MasterService>(std::move(link), clock);
    const auto config = network.compiled();
    recorder = std::make_unique<RunRecorder>(config);
    service->channels().commands.push(GoOnlineCommand{config, AlState::kOp});
    (void)service->step();
    drain();
  }
  void drain() {
    for (auto& event : service->channels().events.drain()) events.push_back(std::move(event));
    const auto seen = samples.size();
    service->channels().samples.pop(samples);
    recorder->add(std::span(samples).subspan(seen));
    service->channels().snapshot.read(snapshot);
  }
  /// `time`: since the start.
  void run_until(Nanoseconds time) {
    while (clock.now() < start + time) {
      service->run_for(std::min<Nanoseconds>(100 * kMillisecond, start + time - clock.now()));
      drain();
    }
  }
  [[nodiscard]] std::string log() const {
    std::string text;
    for (const auto& event : events) {
      if (const auto line = cli::event_text(event, start); !line.empty()) text += line + "\n";
    }
    return text;
  }
  /// `slave` -2: whoever.
  [[nodiscard]] std::size_t count(EventKind kind, int slave = -2) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        events, [&](const Event& e) { return e.kind() == kind && (slave == -2 || e.slave == slave); }));
  }
};

}  // namespace syncline::test
