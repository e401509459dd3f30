// SPDX-License-Identifier: Apache-2.0
#include "link/bus_responder.h"

#include <algorithm>
#include <cmath>

#include "link/raw_port.h"
#include "protocol/frame.h"
#include "sim/sim_bus.h"
#include "support/clock.h"

namespace syncline {
namespace {

/// The segment's own life (watchdogs, SYNC units, mailboxes) goes on in steps of this when no frame comes.
constexpr Nanoseconds kIdleStep = kMillisecond;
constexpr Nanoseconds kAwayStep = 5 * kMillisecond;  // while the adapter is away
/// Memory of how often the next frame came within the time of looking for it, and the share that is worth the
/// processor.
constexpr double kLuckMemory = 0.02, kWorthIt = 0.8;
/// A reply that is due so soon is waited for awake: woken up by the timer it would leave as much too late as the whole
/// way through a small segment takes, and a master would measure the host instead of the bus.
constexpr Nanoseconds kAwake = 60 * kMicrosecond;

}  // namespace

Nanoseconds ResponderCounters::service_quantile(double share) const {
  std::uint64_t total = 0;
  for (const auto count : service) total += count;
  if (total == 0) return 0;
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(total)));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < service.size(); ++i) {
    seen += service[i];
    if (seen >= wanted) return std::min(static_cast<Nanoseconds>(i + 1) * kBucket, longest_service);
  }
  return longest_service;
}

const ResponderCounters& BusResponder::counters() {
  counters_.dropped = port_.dropped();
  return counters_;
}

Status BusResponder::serve(Nanoseconds end, const std::atomic<bool>& stop) {
  while (!stop.load(std::memory_order_relaxed)) {
    const auto taken = take_frame();
    auto sent = taken ? send_due() : Status(tl::unexpected(taken.error()));
    if (!sent) {
      if (sent.error().code != ErrorCode::kLinkDown) return sent;
      // The cable is pulled: the segment lives on, and what was on its way is lost.
      replies_.clear();
      const auto now = clock_.now();
      if (end > 0 && now >= end) return {};
      bus_.advance_to(std::max(now, bus_time_));
      bus_time_ = std::max(now, bus_time_);
      clock_.sleep_until(now + kAwayStep);
      continue;
    }
    if (*taken) continue;
    const auto now = clock_.now();
    if (end > 0 && now >= end) return {};
    if (now - bus_time_ >= kIdleStep) {
      bus_.advance_to(now);
      bus_time_ = now;
    }
    if (looks(now)) continue;
    if (!replies_.empty() && replies_.front().due - now <= kAwake && options_.spin > 0) continue;
    port_.wait(idle_time(now, end));
  }
  return {};
}

bool BusResponder::looks(Nanoseconds now) const {
  if (options_.spin == 0) return false;
  if (luck_ > kWorthIt && now - last_frame_ < options_.spin) return true;
  const auto window = forecast_.next();
  return window && now >= window->from && now <= window->until;
}

/// A frame has come: would looking for it have been worth the time, as a rule?
void BusResponder::learn(Nanoseconds now) {
  const bool soon = now - last_frame_ < options_.spin;
  luck_ += kLuckMemory * ((soon ? 1 : 0) - luck_);
}

Nanoseconds BusResponder::idle_time(Nanoseconds now, Nanoseconds end) const {
  auto until = bus_time_ + kIdleStep;
  if (const auto window = options_.spin > 0 ? forecast_.next() : std::nullopt; window && window->from > now)
    until = std::min(until, window->from);
  if (!replies_.empty()) until = std::min(until, replies_.front().due - (options_.spin > 0 ? kAwake : 0));
  if (end > 0) until = std::min(until, end);
  return until - now;
}

Result<bool> BusResponder::take_frame() {
  const auto found = port_.poll();
  if (!found) return tl::unexpected(found.error());
  if (!*found) return false;
  const auto& frame = **found;
  forecast_.arrived(frame.arrival_time);
  ++counters_.frames;
  counters_.bytes += frame.bytes.size();
  auto& reply = replies_.emplace_back();
  reply.length = std::min(frame.bytes.size(), reply.bytes.size());
  std::copy_n(frame.bytes.begin(), reply.length, reply.bytes.begin());

  // The segment never runs backwards, also when the frame arrived while it was being brought up to date.
  const auto started = clock_.now();
  // Nor does a frame start before the one in front has left the wire.
  bus_time_ = std::max({bus_time_, frame.arrival_time, wire_free_});
  wire_free_ = bus_time_ + wire_time_ns(reply.length);
  const auto returned = bus_.execute(std::span(reply.bytes).first(reply.length), bus_time_);
  const auto finished = clock_.now();
  learn(started);
  last_frame_ = finished;
  const auto service = finished - started;
  counters_.longest_service = std::max(counters_.longest_service, service);
  const auto bucket = std::min<std::size_t>(static_cast<std::size_t>(service / ResponderCounters::kBucket),
                                            ResponderCounters::kBuckets - 1);
  ++counters_.service[bucket];
  if (returned.lost) {
    ++counters_.lost;
    replies_.pop_back();
  } else {
    reply.due = returned.arrival_time;
  }
  return true;
}

Status BusResponder::send_due() {
  while (!replies_.empty() && replies_.front().due <= clock_.now()) {
    const auto& reply = replies_.front();
    if (auto status = port_.send(std::span(reply.bytes).first(reply.length)); !status) return status;
    replies_.pop_front();
  }
  return {};
}

}  // namespace syncline
