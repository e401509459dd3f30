// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "link/link.h"
#include "master/exchange/bus.h"
#include "tests/support/simulated_network.h"

namespace syncline::test {

/// Passes frames through and counts them.
class CountingLink final : public Link {
 public:
  explicit CountingLink(std::unique_ptr<Link> inner) : inner_(std::move(inner)) {}
  Status send(std::span<const std::uint8_t> frame) override {
    ++frames;
    bytes += frame.size();
    return inner_->send(frame);
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    return inner_->receive(buffer, deadline);
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }
  std::size_t frames = 0;
  std::size_t bytes = 0;

 private:
  std::unique_ptr<Link> inner_;
};

/// A line of terminals and drives, no two of the same product: every fourth is a drive.
inline SimulatedNetwork different_slaves(std::size_t count) {
  SimulatedNetwork network;
  const auto drive = servo();
  for (std::size_t i = 0; i < count; ++i) {
    auto device = i % 4 == 3 ? drive : io8();
    device.identity.product_code += static_cast<std::uint32_t>(i) << 8;
    device.name = fmt::format("{} {}", device.name, i);
    network.add(device);
    network.sim.slaves.back().serial_no = static_cast<std::uint32_t>(5000 + i);
  }
  return network;
}

/// A line of the same drive, told apart by serial number only.
inline SimulatedNetwork identical_slaves(std::size_t count) {
  SimulatedNetwork network;
  const auto drive = servo();
  for (std::size_t i = 0; i < count; ++i) {
    network.add(drive);
    network.sim.slaves.back().serial_no = static_cast<std::uint32_t>(5000 + i);
    network.sim.slaves.back().alias = static_cast<std::uint16_t>(i + 1);
  }
  return network;
}

}  // namespace syncline::test
