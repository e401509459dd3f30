// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/clock_amendment.h"

#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {

Status ClockAmendment::run(FrameExchange& exchange, const Request& request, SendStamp& stamp, Nanoseconds deadline) {
  frame_.clear();
  write_ = reading_ = {};
  if (request.depth) {
    depth_ = {*request.depth};
    filter_ = {Command::kFpwr, device_address(request.station, reg::kFilterDepthDifference), depth_};
    (void)frame_.add(filter_);
  }
  told_ = request.told;
  const auto address = device_address(request.station, reg::kSystemTime);
  if (told_) {
    write_ = {Command::kFpwr, address, written_};
    write_.stamped = true;
    write_.corrected_by_link = corrected_by_link_ && &stamp != this;
    (void)frame_.add(write_);
  }
  reading_ = {Command::kFprd, address, read_};
  (void)frame_.add(reading_);
  sending_ = true;
  auto status = exchange.send(frame_, &stamp);
  sending_ = false;
  if (!status) return status;
  std::array<PendingFrame*, 1> frames{&frame_};
  return exchange.collect(frames, deadline);
}

Status ClockAmendment::settle(FrameExchange& exchange, const Request& request, Nanoseconds deadline) {
  if (auto sent = run(exchange, {request.station, request.depth, false}, *this, deadline); !sent) return sent;
  const auto time = reading();
  if (!request.told || !time) return {};
  ahead_ = static_cast<Nanoseconds>(*time) - stamped_at_;
  auto sent = run(exchange, {request.station, std::nullopt, true}, *this, deadline);
  ahead_.reset();
  return sent;
}

void ClockAmendment::stamp(Nanoseconds send_time) {
  stamped_at_ = send_time;
  if (ahead_) write(send_time + *ahead_);
}

void ClockAmendment::write(Nanoseconds time) { store_le(std::span(written_), static_cast<std::uint32_t>(time)); }

std::optional<std::uint32_t> ClockAmendment::reading() const {
  if (!frame_.answered() || (told_ && !write_.done()) || !reading_.done()) return std::nullopt;
  return load_le<std::uint32_t>(read_);
}

}  // namespace syncline
