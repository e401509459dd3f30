// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/clock_feed.h"

#include <algorithm>

#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {

ClockFeed::ClockFeed(Nanoseconds cycle)
    : count_(static_cast<std::size_t>(
          std::clamp<Nanoseconds>(cycle / 16 / wire_time_ns(kMinEthernetFrame), 1, kMostFrames))) {}

void ClockFeed::start(std::uint16_t station) {
  address_ = device_address(station, reg::kSystemTime);
  on_ = true;
}

std::span<PendingFrame> ClockFeed::prepare() {
  if (!on_) return {};
  for (std::size_t i = 0; i < count_; ++i) {
    slots_[i].datagram = {Command::kFrmw, address_, slots_[i].time};
    slots_[i].datagram.stamped = true;
    frames_[i].clear();
    (void)frames_[i].add(slots_[i].datagram);
  }
  return std::span(frames_).first(count_);
}

void ClockFeed::stamp(Nanoseconds reference_time) {
  if (!on_) return;
  for (std::size_t i = 0; i < count_; ++i) {
    if (!slots_[i].datagram.answered) store_le(std::span(slots_[i].time), static_cast<std::uint32_t>(reference_time));
  }
}

}  // namespace syncline
