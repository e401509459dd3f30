// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "channels/command.h"
#include "channels/master_channels.h"
#include "fuzz/bus_targets.h"
#include "fuzz/lying_link.h"
#include "master/exchange/bus.h"
#include "master/master_service.h"
#include "master/scan/bus_scanner.h"
#include "tests/support/simulated_network.h"

namespace syncline::fuzz {
namespace {

struct Machine {
  test::SimulatedNetwork network;
  NetworkConfig config;
};

/// A terminal and a drive with a mailbox; with clocks it takes seconds of virtual time to bring it up.
Machine machine(bool clocks) {
  Machine made;
  made.network.add(test::io8());
  made.network.add(test::servo(), "servo-y");
  made.network.project.master.cycle_time = 4 * kMillisecond;
  if (!clocks) {
    for (auto& slave : made.network.project.slaves) slave.dc.op_mode.clear();
  }
  made.config = made.network.compiled();
  return made;
}

/// On a link of its own, as the programs do.
void scan(std::unique_ptr<Link> link, Clock& clock, bool look_only) {
  FrameExchange exchange(*link, clock);
  Bus bus(exchange, clock, nullptr);
  (void)scan_slaves(bus, {.look_only = look_only}, {});
}

void bring_up(MasterService& service, const NetworkConfig& config, AlState target) {
  service.channels().commands.push(GoOnlineCommand{config, target});
  (void)service.step();
  service.run_for(100 * kMillisecond);
}

}  // namespace

void run_master(std::span<const std::uint8_t> bytes) {
  static const Machine plain = machine(false), synchronised = machine(true);
  constexpr Nanoseconds kLongest = 600 * kSecond;
  Script script(bytes);
  const auto what = script.byte();
  const auto& used = what % 16 == 15 ? synchronised : plain;
  VirtualClock clock;
  const auto begin = clock.now();
  if (what % 4 < 2) scan(std::make_unique<LyingLink>(used.network.link(clock), script), clock, what % 4 == 1);
  MasterService service(std::make_unique<LyingLink>(used.network.link(clock), script), clock);
  if (what % 4 > 0) bring_up(service, used.config, what % 4 == 2 ? AlState::kPreop : AlState::kOp);
  service.shut_down();
  (void)service.channels().events.drain();
  promise(clock.now() - begin < kLongest);
}

std::vector<Bytes> master_scripts() {
  std::vector<Bytes> scripts;
  for (const std::uint8_t what : {0, 1, 2, 3, 15}) {
    Bytes script{what};
    // Honest for a while, then each kind of lie in turn.
    script.insert(script.end(), 20U * (what + 1U), 0);
    for (std::uint8_t lie = 0; lie < 8; ++lie) {
      for (const std::uint8_t byte : {0x80 + lie, 0, 1, 2, 0, 0, 0, 0}) script.push_back(byte);
    }
    scripts.push_back(script);
  }
  return scripts;
}

}  // namespace syncline::fuzz
