// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "master/clocks/dc_setup.h"
#include "protocol/registers.h"
#include "support/random.h"
#include "tests/support/scan_bed.h"
#include "tests/support/simulated_network.h"

namespace syncline::test {

/// A segment of up to `size` terminals wired at random: lines, drop lines, branches at junctions; cables of 0.2 to 100
/// m, quartzes of +-50 ppm, clocks that wrap soon. `mixed`: some have receive times only, some no clock at all.
inline SimulatedNetwork random_tree(std::size_t size, std::uint64_t seed, bool mixed) {
  constexpr std::array<std::uint8_t, 3> kBranches{3, 1, 2};
  SimulatedNetwork network;
  Random random(seed);
  struct Open {
    std::uint16_t parent;
    std::uint8_t port;
  };
  std::vector<Open> open;  // the frame comes to the last one first
  while (network.sim.slaves.size() < size) {
    const auto position = static_cast<std::uint16_t>(network.sim.slaves.size());
    network.add(io8());
    auto& slave = network.sim.slaves.back();
    slave.cable_m = 0.2 + random.uniform() * 99.8;
    slave.oscillator.ppm = random.uniform() * 100 - 50;
    slave.oscillator.start_offset = static_cast<Nanoseconds>(random.uniform() * 8.6e9);
    if (position > 0) {
      const auto at = open.back();
      open.pop_back();
      slave.parent = at.parent;
      slave.parent_port = at.port;
      network.project.slaves.back().previous = PreviousPort{at.parent, at.port};
      const double kind = random.uniform();
      if (mixed && kind < 0.4) {
        slave.dc.system_time = false;
        slave.dc.receive_times = kind < 0.2;
        network.project.slaves.back().dc.op_mode.clear();
      }
    }
    // Slaves without any clock are not told apart from a cable: they have two ports.
    const bool branches = slave.dc.receive_times && random.uniform() < 0.2;
    std::vector<Open> own;
    for (const auto port : kBranches) {
      if (port == 1 ? (open.empty() && own.empty()) || random.uniform() < 0.85 : branches && random.uniform() < 0.7) {
        own.push_back({position, port});
      }
    }
    open.insert(open.end(), own.rbegin(), own.rend());
    if (open.empty()) open.push_back({position, 1});
  }
  return network;
}

/// Clocks of a simulated segment as DcSetup leaves them.
class ClockBed {
 public:
  explicit ClockBed(SimulatedNetwork network) : network_(std::move(network)), config_(network_.compiled()) {
    auto bus = sim::SimBus::create(network_.sim, clock.now());
    if (!bus) return;
    bus_ = bus->get();
    link_ = std::make_unique<CountingLink>(make_simulated_link("sim", std::move(*bus), clock));
    exchange_ = std::make_unique<FrameExchange>(*link_, clock);
    access_ = std::make_unique<Bus>(*exchange_, clock);
  }
  /// Gives station addresses and sets up the clocks.
  Result<DcNetwork> set_up() {
    if (bus_ == nullptr) return fail(ErrorCode::kConfiguration, "the segment cannot be made");
    for (std::size_t i = 0; i < config_.slaves.size(); ++i) {
      const auto adp = Position{static_cast<std::uint16_t>(i)}.auto_increment_address();
      const auto wkc = access_->write(Command::kApwr, adp, reg::kStationAddress, config_.slaves[i].station_address);
      if (!wkc) return tl::unexpected(wkc.error());
    }
    std::vector<std::size_t> all(config_.slaves.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    result_ = DcSetup(*access_, config_, all).run();
    return result_;
  }
  /// Of the synchronised slaves' PDI views of the system time to the reference clock's, now.
  [[nodiscard]] std::int64_t largest_clock_difference() const {
    bus_->advance_to(clock_now());
    const auto low = [this](std::size_t i) { return static_cast<std::uint32_t>(bus_->system_time(i)); };
    std::int64_t largest = 0;
    for (std::size_t i = 0; i < result_->slaves.size(); ++i) {
      if (!result_->slaves[i].synchronised) continue;
      const auto difference = static_cast<std::int32_t>(low(i) - low(result_->reference_clock));
      largest = std::max<std::int64_t>(largest, std::abs(std::int64_t{difference}));
    }
    return largest;
  }
  [[nodiscard]] sim::SimBus& bus() const { return *bus_; }
  [[nodiscard]] const NetworkConfig& config() const { return config_; }
  [[nodiscard]] Bus& access() { return *access_; }
  /// Sent since power-on.
  [[nodiscard]] std::size_t frames() const { return link_->frames; }

  VirtualClock clock;

 private:
  [[nodiscard]] Nanoseconds clock_now() const { return const_cast<VirtualClock&>(clock).now(); }

  SimulatedNetwork network_;
  NetworkConfig config_;
  sim::SimBus* bus_ = nullptr;
  std::unique_ptr<CountingLink> link_;
  std::unique_ptr<FrameExchange> exchange_;
  std::unique_ptr<Bus> access_;
  Result<DcNetwork> result_ = fail(ErrorCode::kNoResponse, "not set up");
};

}  // namespace syncline::test
