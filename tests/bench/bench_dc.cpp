// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "bench/ratio_report.h"
#include "support/clock_bed.h"

/// What the initialisation of the clocks costs: frames and time on the bus from power-on until all clocks are within
/// 100 ns, against a burst of a fixed length with the start values after a reset.
namespace syncline::bench {
namespace {

constexpr std::int64_t kNear = 100;  // ns

struct Took {
  std::size_t frames = 0;
  Nanoseconds time = 0;
  std::int64_t difference = 0;
  std::string error;
};

test::SimulatedNetwork line(std::size_t slaves) {
  test::SimulatedNetwork network;
  Random random(slaves);
  for (std::size_t i = 0; i < slaves; ++i) {
    network.add(test::io8());
    network.sim.slaves.back().cable_m = 1 + random.uniform() * 29;
    network.sim.slaves.back().oscillator.ppm = random.uniform() * 100 - 50;
  }
  return network;
}

Took set_up(test::SimulatedNetwork network, DcmMode mode) {
  network.project.master.dc.dcm.mode = mode;
  test::ClockBed bed(std::move(network));
  const auto begin = bed.clock.now();
  const auto clocks = bed.set_up();
  if (!clocks) return {0, 0, 0, "the clocks cannot be set up"};
  return {bed.frames(), bed.clock.now() - begin, bed.largest_clock_difference(), {}};
}

void compare(RatioReport& report, std::size_t slaves, DcmMode mode, double gate) {
  auto fixed = line(slaves);
  auto& dc = fixed.project.master.dc;
  dc.burst_total = 15'000;
  dc.burst_ends_early = false;
  dc.loop = {0x1000, std::uint8_t{0}, std::uint8_t{12}};
  const auto slow = set_up(fixed, mode);
  const auto fast = set_up(line(slaves), mode);
  const auto name = fmt::format("clocks of {} slaves, {}", slaves, dcm_mode_name(mode));
  if (!fast.error.empty() || !slow.error.empty()) return report.add_failure(name, fast.error + slow.error);
  fmt::print("{}: {} frames, {:.0f} ms, {} ns apart; fixed burst: {} frames, {:.0f} ms, {} ns apart\n", name, fast.frames,
             static_cast<double>(fast.time) / 1e6, fast.difference, slow.frames, static_cast<double>(slow.time) / 1e6,
             slow.difference);
  if (fast.difference >= kNear) return report.add_failure(name, fmt::format("{} ns apart", fast.difference));
  report.add_count(name, static_cast<double>(fast.frames), "frames", static_cast<double>(slow.frames), "frames", gate);
}

}  // namespace
}  // namespace syncline::bench

int main() {
  using namespace syncline;
  bench::RatioReport report;
  for (const std::size_t slaves : {1U, 10U, 100U, 200U}) {
    bench::compare(report, slaves, DcmMode::kMasterShift, 0.2);
    bench::compare(report, slaves, DcmMode::kBusShift, 0);
  }
  return report.finish("Distributed clocks");
}
