// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/missing_frames.h"

#include <algorithm>
#include <utility>

#include "protocol/datagram.h"

namespace syncline {
namespace {

/// Nothing comes back at all: longer than most stalls of a host or a switch, short enough to be told in time.
constexpr Nanoseconds kMissingPatience = 20 * kMillisecond;

bool same_frame(const MissingFrames::Frame& frame, const DatagramHeader& header) {
  if (frame.command != header.command || frame.length != header.length) return false;
  const bool counted = is_auto_increment(frame.command) || is_broadcast(frame.command);
  return ((frame.address ^ header.address) & (counted ? 0xFFFF'0000U : 0xFFFF'FFFFU)) == 0;
}

}  // namespace

void MissingFrames::miss(std::uint8_t index, const Frame& frame) {
  forget(index);
  slots_[index] = {State::kMissing, frame};
  ++missing_;
}

void MissingFrames::lose(Slot& slot) {
  slot.state = State::kLost;
  --missing_;
  if (news_.lost++ == 0 || slot.frame.send_time < news_.first_lost) news_.first_lost = slot.frame.send_time;
}

void MissingFrames::returned(std::uint64_t sequence) {
  if (missing_ == 0) return;
  for (auto& slot : slots_) {
    if (slot.state == State::kMissing && slot.frame.sequence < sequence) lose(slot);
  }
}

bool MissingFrames::take_late(const DatagramHeader& header, Nanoseconds arrival) {
  auto& slot = slots_[header.index];
  if (slot.state == State::kNone || !same_frame(slot.frame, header)) return false;
  ++news_.late;
  if (slot.state == State::kLost) ++news_.late_after_lost;
  if (slot.state == State::kMissing) --missing_;
  // The stamp of a frame that waited in the host's buffers may lie before the deadline at which nobody had looked yet.
  news_.late_by = std::max({news_.late_by, arrival - slot.frame.deadline, Nanoseconds{0}});
  slot.state = State::kNone;
  if (slot.frame.cyclic && std::exchange(late_cycle_, slot.frame.deadline) != slot.frame.deadline) ++news_.late_cycles;
  returned(slot.frame.sequence);
  return true;
}

void MissingFrames::forget(std::uint8_t index) {
  auto& slot = slots_[index];
  if (slot.state == State::kMissing) lose(slot);
  slot.state = State::kNone;
}

void MissingFrames::expire(Nanoseconds now) {
  if (missing_ == 0) return;
  for (auto& slot : slots_) {
    if (slot.state == State::kMissing && now - slot.frame.deadline > kMissingPatience) lose(slot);
  }
}

void MissingFrames::give_up() {
  for (auto& slot : slots_) {
    if (slot.state == State::kMissing) lose(slot);
  }
}

void MissingFrames::forget_all() {
  slots_.fill({});
  missing_ = 0;
  news_ = {};
}

MissingFrames::News MissingFrames::take_news() { return std::exchange(news_, {}); }

}  // namespace syncline
