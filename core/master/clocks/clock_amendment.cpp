// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/clock_amendment.h"

#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {

Status ClockAmendment::run(FrameExchange& exchange, std::uint16_t station, SendStamp& stamp, Nanoseconds deadline) {
  frame_.clear();
  const auto address = device_address(station, reg::kSystemTime);
  write_ = {Command::kFpwr, address, written_};
  write_.stamped = true;
  write_.corrected_by_link = corrected_by_link_;
  (void)frame_.add(write_);
  reading_ = {Command::kFprd, address, read_};
  (void)frame_.add(reading_);
  sending_ = true;
  auto status = exchange.send(frame_, &stamp);
  sending_ = false;
  if (!status) return status;
  std::array<PendingFrame*, 1> frames{&frame_};
  return exchange.collect(frames, deadline);
}

void ClockAmendment::write(Nanoseconds time) { store_le(std::span(written_), static_cast<std::uint32_t>(time)); }

std::optional<std::uint32_t> ClockAmendment::reading() const {
  if (!frame_.answered() || !write_.done() || !reading_.done()) return std::nullopt;
  return load_le<std::uint32_t>(read_);
}

}  // namespace syncline
