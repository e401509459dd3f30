// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/drift_compensation.h"

#include <algorithm>

#include "dc/clock_registers.h"
#include "master/exchange/bus.h"
#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "protocol/system_time_difference.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr Nanoseconds kBurstReplyTimeout = 10 * kMillisecond;
/// So many at a time stay in the buffers of any network card.
constexpr std::uint32_t kMostInFlight = 32;
/// Wire-ored, and of one frame: several in a row are meant, because noise is near to nothing now and then.
constexpr std::uint32_t kSettledDeviation = 31;
constexpr int kSettledInARow = 8;
/// Before the filters have seen some messages, the small deviation of the beginning says nothing.
constexpr std::uint32_t kMinimum = 600;
/// The filters of a steered reference clock average over 2^12 messages.
constexpr std::uint32_t kSteeredMinimum = 4096;
/// Quartzes far apart need more frames than planned; as many again, then it is the cyclic frames' turn.
constexpr std::uint32_t kBurstPatience = 2;
constexpr int kLastAttempts = 4;

}  // namespace

DcBurst::DcBurst(Bus& bus, const Plan& plan)
    : bus_(bus), plan_(plan), slots_(std::clamp<std::uint32_t>(plan.bulk, 1, kMostInFlight)) {
  const auto width = plan.wide ? std::size_t{8} : std::size_t{4};
  const auto read = plan.by_place ? Command::kArmw : Command::kFrmw;
  const auto write = plan.by_place ? Command::kApwr : Command::kFpwr;
  for (auto& slot : slots_) {
    slot.read = {read, plan.address, std::span(slot.time).first(width)};
    slot.steer_write = {write, plan.address, std::span(slot.steer).first(4)};
    slot.window = {Command::kBrd, device_address(0, reg::kSystemTimeDifference), slot.deviation};
    slot.read.stamped = slot.steer_write.stamped = true;
  }
}

void DcBurst::fill(Slot& slot, bool with_window) {
  slot.time.fill(0);
  slot.deviation.fill(0);
  slot.frame.clear();
  (void)slot.frame.add(slot.read);
  if (plan_.steer && anchor_) (void)slot.frame.add(slot.steer_write);
  if (with_window) (void)slot.frame.add(slot.window);
}

void DcBurst::stamp(Nanoseconds send_time) {
  // Frames of a bulk leave one behind the other, whatever the host's clock says when it hands them over.
  sending_->on_wire = std::max(send_time, wire_free_);
  wire_free_ = sending_->on_wire + wire_time_ns(kEthernetHeaderSize + kEtherCatHeaderSize + sending_->frame.size());
  if (!anchor_) return;
  const auto expected = static_cast<std::uint64_t>(sending_->on_wire + *anchor_);
  store_le(sending_->time, expected);  // for slaves in front of the reference clock
  store_le(sending_->steer, expected);
}

Status DcBurst::exchange_bulk(std::uint32_t frames) {
  std::array<PendingFrame*, kMostInFlight> in_flight{};
  std::size_t sent = 0;
  for (; sent < frames; ++sent) {
    auto& slot = slots_[sent];
    fill(slot, sent == 0);
    sending_ = &slot;
    if (auto status = bus_.exchange().send(slot.frame, this); !status) return status;
    in_flight[sent] = &slot.frame;
  }
  const auto deadline = bus_.clock().now() + kBurstReplyTimeout;
  if (auto status = bus_.exchange().collect(std::span(in_flight).first(sent), deadline); !status) return status;
  for (std::size_t i = 0; i < sent; ++i) take(slots_[i]);
  deviation_.reset();
  if (slots_.front().window.done()) {
    deviation_ = SystemTimeDifference{load_le<std::uint32_t>(slots_.front().deviation)}.magnitude();
  }
  outcome_.frames += frames;
  return {};
}

void DcBurst::take(const Slot& slot) {
  if (!slot.read.done()) return;
  outcome_.answered = true;
  // The driver may have got it later than the host thought.
  const auto on_wire = std::max(slot.on_wire, slot.frame.send_time());
  outcome_.host_time = on_wire;
  outcome_.reference_time = dc::extend_32bit(load_le<std::uint32_t>(slot.time), on_wire + anchor_.value_or(0));
  if (!anchor_) anchor_ = outcome_.reference_time - outcome_.host_time;
}

bool DcBurst::settled(std::uint32_t minimum) {
  if (deviation_) settled_in_a_row_ = *deviation_ <= kSettledDeviation ? settled_in_a_row_ + 1 : 0;
  return outcome_.frames >= minimum && settled_in_a_row_ >= kSettledInARow;
}

Result<DcBurst::Outcome> DcBurst::run() {
  const auto minimum = plan_.steer ? kSteeredMinimum : kMinimum;
  const auto total = plan_.ends_early ? std::uint64_t{plan_.total} * kBurstPatience : plan_.total;
  const auto most = static_cast<std::uint32_t>(slots_.size());
  auto next = bus_.clock().now();
  while (outcome_.frames < total) {
    if (auto status = bus_.check_cancel(); !status) return tl::unexpected(status.error());
    // The bulk must leave room in its cycle, or the burst would not keep the cycle's pace.
    const auto end = bus_.clock().now() + plan_.cycle * 6 / 10;
    auto left = static_cast<std::uint32_t>(std::min<std::uint64_t>(plan_.bulk, total - outcome_.frames));
    do {
      const auto frames = std::clamp<std::uint32_t>(left, 1, most);
      if (auto status = exchange_bulk(frames); !status) return tl::unexpected(status.error());
      outcome_.settled = settled(minimum);
      left -= std::min(left, frames);
    } while (left > 0 && bus_.clock().now() < end);
    if (outcome_.settled && plan_.ends_early) break;
    next += plan_.cycle;
    bus_.clock().sleep_until(next);
  }
  for (int attempt = 0; attempt < kLastAttempts && !outcome_.answered; ++attempt) {
    if (auto status = exchange_bulk(1); !status) return tl::unexpected(status.error());
  }
  return outcome_;
}

}  // namespace syncline
