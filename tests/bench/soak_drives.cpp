// SPDX-License-Identifier: Apache-2.0
// soak_drives [DRIVES [SECONDS]]: so many simulated drives (1,000) with clocks are served on one end of a veth pair, in
// a network namespace of its own; a master on the other end has so long (240 s) to lead all of them to OP in a cycle of
// 4 ms: the frames of 1,000 drives cannot be back within one of 1 ms, which it says. On the real clock, so that the
// machine must have little else to do. Exit code 1 when they are not all there, 3 without the permission for a
// namespace.
#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>

#include "app/composition/open_link.h"
#include "channels/event.h"
#include "config/frame_time.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "engine/simulate_bus.h"
#include "findings/error_text.h"
#include "link/pcap_link.h"
#include "support/net_namespace.h"
#include "tests/support/small_machines.h"

namespace syncline::bench {
namespace {

/// Patient enough for a host without real time: what is proved here is the number, not the pace. The slaves' clocks
/// stay out of it: the master follows them.
test::SimulatedNetwork line_of(std::size_t drives) {
  test::SimulatedNetwork network;
  const auto drive = test::small_servo();
  for (std::size_t i = 0; i < drives; ++i) network.add(drive, "servo-y");
  auto& master = network.project.master;
  master.cycle_time = 4 * kMillisecond;
  master.dc.sync_window.enabled = false;
  master.dc.dcm.mode = DcmMode::kMasterShift;
  master.dc.dcm.in_sync_limit = kMillisecond;
  master.recovery.error_tries = 1'000;
  return network;
}

int soak(std::size_t drives, Nanoseconds limit) {
  const test::NetNamespace wire;
  if (!wire.ready()) {
    fmt::print("no permission to create a network namespace with a veth pair\n");
    return 3;
  }
  const auto network = line_of(drives);
  const auto config = network.compiled();
  const auto need = cycle_need(config);
  fmt::print("frames of a cycle at 100 Mbit/s: {} us on the wire, {} us through the drives and back, as an estimate\n",
             need.wire / kMicrosecond, need.travel / kMicrosecond);
  std::atomic<bool> served{false}, over{false}, there{false};
  Result<SimulateReport> bus;
  std::thread server([&] {
    SimulateRequest request;
    request.adapter = test::NetNamespace::kBusEnd;
    request.stop = &over;
    request.on_ready = [&](const SimConfig&, const AdapterInfo&) { served = true; };
    bus = simulate_bus(network.sim, request);
    served = true;
  });
  while (!served) std::this_thread::yield();

  Nanoseconds begin = 0, reached = 0;
  std::string failures;
  RunRequest request;
  request.duration = limit;
  request.stop = &there;
  request.on_event = [&](const Event& event) {
    if (begin == 0) begin = event.time;
    const auto* change = event.as<events::StateChanged>();
    if (change != nullptr && event.slave == -1 && change->to == AlState::kOp) {
      reached = event.time;
      there = true;
    }
    if (const auto* failure = event.as<events::Failure>()) failures += "  " + describe(failure->error) + "\n";
  };
  const auto outcome = run_network(config, open_link(std::string("nic:") + test::NetNamespace::kMasterEnd), request);
  over = true;
  server.join();
  if (!outcome || !bus) {
    fmt::print("{}\n", describe(outcome ? bus.error() : outcome.error()));
    return 1;
  }
  fmt::print("{} drives over veth: {}, {} frames served, {} lost\n{}", drives,
             there ? fmt::format("all in OP after {:.1f} s", static_cast<double>(reached - begin) / 1e9)
                   : std::string("not all in OP"),
             bus->counters.frames, bus->counters.lost, failures);
  return there ? 0 : 1;
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  const auto drives = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1'000UL;
  const auto seconds = argc > 2 ? std::strtol(argv[2], nullptr, 10) : 240L;
  return syncline::bench::soak(drives, seconds * syncline::kSecond);
}
