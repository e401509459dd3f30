// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <optional>

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

/// Bursts of growing length: the frames behind which the clocks are near and stay so.
std::optional<std::size_t> frames_until_near(std::size_t slaves, DcmMode mode) {
  constexpr std::uint32_t kStep = 250, kLongest = 5'000;
  std::optional<std::size_t> near;
  for (std::uint32_t total = kStep; total <= kLongest; total += kStep) {
    auto network = line(slaves);
    network.project.master.dc.burst_total = total;
    network.project.master.dc.burst_ends_early = false;
    const auto took = set_up(std::move(network), mode);
    if (!took.error.empty() || took.difference >= kNear) {
      near.reset();
    } else if (!near) {
      near = took.frames;
    }
  }
  return near;
}

/// A steered reference clock goes on learning to follow the host when the others follow it already.
void compare_steered(RatioReport& report, std::size_t slaves) {
  const auto name = fmt::format("clocks of {} slaves, bus-shift", slaves);
  const auto near = frames_until_near(slaves, DcmMode::kBusShift);
  const auto whole = set_up(line(slaves), DcmMode::kBusShift);
  if (!near || !whole.error.empty()) return report.add_failure(name, "never within 100 ns");
  fmt::print(
      "{}: near after {} frames; the whole burst, until the reference clock follows the host: {} frames, {:.0f} ms, "
      "{} ns apart\n",
      name, *near, whole.frames, static_cast<double>(whole.time) / 1e6, whole.difference);
  report.add_count(name, static_cast<double>(*near), "frames", 15'000, "frames", 0.2);
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
  fmt::print("{}: {} frames, {:.0f} ms, {} ns apart; fixed burst: {} frames, {:.0f} ms, {} ns apart\n", name,
             fast.frames, static_cast<double>(fast.time) / 1e6, fast.difference, slow.frames,
             static_cast<double>(slow.time) / 1e6, slow.difference);
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
    bench::compare_steered(report, slaves);
  }
  return report.finish("Distributed clocks");
}
