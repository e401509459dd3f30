// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "link/simulated_link.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "support/byte_order.h"
#include "tests/support/simulated_network.h"

namespace syncline::test {

/// The simulated bus behind a link that counts frames, keeps, loses or holds them back; what stands in its slaves is
/// read and written beside the master, as another master's frame would do it. One thread; virtual time.
class SimulatedSegment final : public Link {
 public:
  SimulatedSegment(VirtualClock& clock, const SimConfig& config) : clock_(clock) {
    auto bus = sim::SimBus::create(config, clock.now()).value();
    bus_ = bus.get();
    SimulatedHost host;
    host.adapter = AdapterFaults::of(config, clock.now());
    inner_ = make_simulated_link("sim", std::move(bus), clock, host);
  }

  /// The next so many frames go into nothing: no slave sees them.
  void lose(int frames) { lose_ = frames; }
  std::size_t frames_sent = 0;
  bool record = false;
  std::vector<std::vector<std::uint8_t>> sent;  // filled when `record`
  std::function<void()> on_frame;               // before a frame is executed
  /// May change what comes back, as a slave would that lies.
  std::function<void(DatagramView&)> on_reply;

  template <std::unsigned_integral T>
  [[nodiscard]] T get(std::size_t position, std::uint16_t address) const {
    return load_le<T>(bus_->peek(position, address, sizeof(T)));
  }
  /// Writes to a register or to memory; false: the slave has not taken it.
  template <std::unsigned_integral T>
  bool set(std::size_t position, std::uint16_t address, T value) {
    const auto data = le_bytes(value);
    FrameBuilder builder;
    constexpr std::array<std::uint8_t, 6> kMac{2, 0, 0, 0, 0, 9};
    builder.set_addresses(kMac, kMac);
    const auto place = Position{static_cast<std::uint16_t>(position)}.auto_increment_address();
    if (!builder.add(Command::kApwr, 1, device_address(place, address), data)) return false;
    const auto built = builder.finish();
    std::vector<std::uint8_t> frame(built.begin(), built.end());
    if (bus_->execute(frame, clock_.now()).lost) return false;
    FrameReader reader(frame);
    return reader.next()->wkc() == 1;
  }
  [[nodiscard]] sim::SimBus& bus() { return *bus_; }

  Status send(std::span<const std::uint8_t> frame) override {
    ++frames_sent;
    if (on_frame) on_frame();
    if (record) sent.emplace_back(frame.begin(), frame.end());
    if (lose_ > 0) {
      --lose_;
      return {};
    }
    return inner_->send(frame);
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    auto received = inner_->receive(buffer, deadline);
    if (on_reply && received && received->length > 0) {
      FrameReader reader(buffer.first(received->length));
      while (auto datagram = reader.next()) on_reply(*datagram);
    }
    return received;
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  VirtualClock& clock_;
  sim::SimBus* bus_ = nullptr;
  std::unique_ptr<Link> inner_;
  int lose_ = 0;
};

/// A line of so many terminals without mailbox, their station addresses 1001 and so on.
inline SimConfig terminals(std::size_t count) {
  SimulatedNetwork network;
  for (std::size_t i = 0; i < count; ++i) network.add(io8());
  return network.sim;
}
inline void give_addresses(SimulatedSegment& segment, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    segment.set(i, reg::kStationAddress, static_cast<std::uint16_t>(1001 + i));
  }
}

/// The reply to a datagram that slave `position` of `count` was asked for by its place.
inline bool is_reply_of(const DatagramView& reply, std::size_t position, std::size_t count, std::uint16_t ado) {
  return is_auto_increment(reply.header.command) && reply.header.ado() == ado &&
         reply.header.adp() == static_cast<std::uint16_t>(count - position);
}

}  // namespace syncline::test
