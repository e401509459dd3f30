// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/delay_latch.h"

#include <algorithm>
#include <utility>

#include "master/exchange/slave_address.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

std::uint32_t port_time(std::span<const std::uint8_t> ports, std::size_t port) {
  return load_le<std::uint32_t>(ports.subspan(4 * port));
}

}  // namespace

DelayLatch::DelayLatch(std::span<const SlaveAddress> slaves, std::vector<dc::DelayNode> nodes, std::size_t rounds)
    : nodes_(std::move(nodes)), slaves_(nodes_.size()), most_rounds_(std::max<std::size_t>(rounds, 1)) {
  trigger_ = {Command::kBwr, device_address(0, reg::kReceiveTimePort0), zeros_};
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (auto& port : slaves_[i].differences) port.resize(most_rounds_);
    slaves_[i].processing.resize(most_rounds_);
    const auto& active = nodes_[i].active;
    const auto base = std::ranges::find(active, true) - active.begin();
    slaves_[i].base = static_cast<std::size_t>(base) % active.size();
    if (nodes_[i].kind == dc::DcKind::kNone) continue;
    reads_.push_back(slaves[i].read(reg::kReceiveTimePort0, slaves_[i].ports));
    port_read_of_.push_back(i);
    if (nodes_[i].kind != dc::DcKind::kFull) continue;
    reads_.push_back(slaves[i].read(reg::kReceiveTimeProcessingUnit, slaves_[i].processing_unit));
    port_read_of_.push_back(SIZE_MAX);
  }
}

Datagram& DelayLatch::trigger() {
  zeros_.fill(0);
  trigger_.answered = false;
  trigger_.wkc = 0;
  return trigger_;
}

std::span<Datagram> DelayLatch::begin_reading() {
  for (auto& read : reads_) {
    read.answered = false;
    read.wkc = 0;
  }
  return reads_;
}

bool DelayLatch::take() {
  for (std::size_t i = 0; i < reads_.size(); ++i) {
    if (port_read_of_[i] != SIZE_MAX && !reads_[i].done()) return false;
  }
  if (rounds_ == most_rounds_) return true;
  for (auto& slave : slaves_) {
    const auto base = port_time(slave.ports, slave.base);
    for (std::size_t port = 0; port < 4; ++port) {
      slave.differences[port][rounds_] = static_cast<std::int32_t>(port_time(slave.ports, port) - base);
    }
    slave.processing[rounds_] = static_cast<std::int32_t>(load_le<std::uint32_t>(slave.processing_unit) - base);
  }
  ++rounds_;
  return true;
}

const std::vector<dc::DelayNode>& DelayLatch::nodes() {
  for (std::size_t i = 0; i < nodes_.size() && rounds_ > 0; ++i) {
    auto& slave = slaves_[i];
    const auto base = port_time(slave.ports, slave.base);
    const auto time = [&](std::vector<std::int32_t>& differences) {
      const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(rounds_ / 2);
      std::nth_element(differences.begin(), middle, differences.begin() + static_cast<std::ptrdiff_t>(rounds_));
      return base + static_cast<std::uint32_t>(*middle);
    };
    for (std::size_t port = 0; port < 4; ++port) nodes_[i].receive_time[port] = time(slave.differences[port]);
    if (nodes_[i].kind == dc::DcKind::kFull) nodes_[i].processing_time = time(slave.processing);
  }
  return nodes_;
}

std::uint64_t DelayLatch::processing_unit(std::size_t slave) const {
  return load_le<std::uint64_t>(slaves_[slave].processing_unit);
}

}  // namespace syncline
