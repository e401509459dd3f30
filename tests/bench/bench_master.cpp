// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bench/ratio_report.h"
#include "channels/command.h"
#include "channels/events/service_events.h"
#include "channels/frame_ring.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "findings/error_text.h"
#include "master/master_service.h"
#include "tests/support/simulated_network.h"

/// What the master costs: time to OP for long buses, bytes on the wire in a cycle.
namespace syncline::bench {
namespace {

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1e6;
  };
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
    const auto* failure = event.as<events::Failure>();
    if (failure != nullptr && result.error.empty()) result.error = describe(failure->error);
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

/// 4 bytes out and 4 in of each slave fit the same 4 bytes of an LRW; nothing smaller carries them.
void bench_frame_bytes(RatioReport& report) {
  const auto bytes = [](bool overlap) {
    auto network = line(50, false);
    network.project.master.overlap_process_data = overlap;
    double sum = 0;
    for (const auto& task : network.compiled().cyclic) {
      for (const auto& frame : task.frames) {
        for (const auto& command : frame.commands) sum += is_logical(command.command) ? command.length() : 0;
      }
    }
    return sum;
  };
  report.add_count("cyclic_frame_bytes_50", bytes(true), "bytes", 50 * 4, "bytes, 4 a slave", 1);
  report.add_count("cyclic_frame_bytes_50, apart", bytes(false), "bytes", 50 * 8, "bytes, 8 a slave", 1);
}

/// Virtual time: the cycles are counted, not this machine's speed.
void gate_bring_up(RatioReport& report) {
  const auto one = bring_up(line(1, true)), many = bring_up(line(100, true));
  if (!one.error.empty() || !many.error.empty()) return report.add_failure("time to OP", one.error + many.error);
  report.add_count("time to OP, 100 CoE drives", many.virtual_seconds * 1000, "ms", one.virtual_seconds * 1000,
                   "ms, one drive", 1.5);
}

/// What the cyclic thread pays for the black box: a frame into the ring, against reading the clock, which each frame
/// costs anyhow.
void bench_kept_frames(RatioReport& report) {
  constexpr std::size_t kFrames = 1'000;
  const std::vector<std::uint8_t> frame(400);
  const RealClock clock;
  Nanoseconds sum = 0;
  const auto read_clock = [&] {
    for (std::size_t i = 0; i < kFrames; ++i) sum += clock.now();
  };
  FrameRing ring;
  const auto push = [&] {
    for (std::size_t i = 0; i < kFrames; ++i) ring.push(frame, sum, FrameDirection::kSent);
  };
  const auto baseline = median_ns(read_clock) / kFrames;
  report.add("frame of 400 bytes, nobody keeps it", median_ns(push) / kFrames, "reading the clock", baseline, 1);
  const auto kept = [&] {
    ring.open();  // what is in it is dropped
    push();
  };
  report.add("frame of 400 bytes into the black box", median_ns(kept) / kFrames, "reading the clock", baseline, 5);
}

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  using namespace syncline::bench;
  bench_bring_up(argc > 1 ? std::stoul(argv[1]) : 1000);
  RatioReport report;
  bench_frame_bytes(report);
  gate_bring_up(report);
  bench_kept_frames(report);
  return report.finish("Master");
}
