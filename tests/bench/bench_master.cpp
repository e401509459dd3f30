// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <string>

#include "bench/ratio_report.h"
#include "config/compile/cyclic_frames.h"
#include "master/master_service.h"
#include "protocol/error_text.h"
#include "tests/support/simulated_network.h"

/// What the master costs: time to OP for long buses, bytes on the wire in a cycle.
namespace syncline::bench {
namespace {

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1e6; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct BringUp {
  double virtual_seconds = 0, cpu_seconds = 0;
  std::string error;
};

BringUp bring_up(const test::SimulatedNetwork& network) {
  VirtualClock clock;
  auto link = network.link(clock);
  if (!link) return {0, 0, "no simulated bus"};
  MasterService service(std::move(link), clock);
  service.channels().commands.push(GoOnlineCommand{network.compiled(), AlState::kOp});
  const auto cpu = cpu_seconds();
  const auto start = clock.now();
  (void)service.step();
  BringUp result{static_cast<double>(clock.now() - start) / 1e9, cpu_seconds() - cpu, {}};
  for (const auto& event : service.channels().events.drain()) {
    if (event.error && result.error.empty()) result.error = describe(*event.error);
  }
  Snapshot snapshot;
  (void)service.channels().snapshot.read(snapshot);
  if (result.error.empty() && snapshot.state != AlState::kOp) result.error = "not in OP";
  return result;
}

test::SimulatedNetwork line(std::size_t slaves, bool drives) {
  test::SimulatedNetwork network;
  network.project.master.cycle_time = slaves > 200 ? 4 * kMillisecond : kMillisecond;
  for (std::size_t i = 0; i < slaves; ++i) {
    if (drives) {
      network.add(test::servo(), "servo-y");
    } else {
      network.add(test::io8());
    }
  }
  return network;
}

void bench_bring_up(std::size_t largest) {
  fmt::print("Time to OP on the virtual clock (DC burst and DCM settle time included)\n");
  for (const bool drives : {false, true}) {
    for (const std::size_t slaves : {1, 10, 100, 1000}) {
      if (slaves > largest) continue;
      const auto found = bring_up(line(slaves, drives));
      fmt::print("  {:>5} {:<10} {:>9.3f} s virtual {:>9.3f} s processor   {}\n", slaves,
                 drives ? "CoE drives" : "terminals", found.virtual_seconds, found.cpu_seconds, found.error);
    }
  }
}


}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  using namespace syncline::bench;
  bench_bring_up(argc > 1 ? std::stoul(argv[1]) : 1000);
  return 0;
}
