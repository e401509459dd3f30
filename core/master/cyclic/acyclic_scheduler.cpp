// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/acyclic_scheduler.h"

#include <algorithm>
#include <utility>

#include "config/frame_time.h"
#include "reasons/brief_reason.h"

namespace syncline {
namespace {

constexpr std::size_t kMostFrames = 8;
/// As long as the shortest frame of its own keeps the wire busy: 64 bytes, preamble and gap. Outputs are valid, and
/// inputs come back, later by no more than that, 6.7 us.
constexpr std::size_t kLongestRide = 84;

std::size_t size_of(const Datagram& datagram) { return kDatagramHeaderSize + datagram.data.size() + kWkcSize; }

}  // namespace

AcyclicScheduler::AcyclicScheduler(RunState& run, const MailboxBits& bits, SyncEventWatch& events)
    : requests_(run),
      mailbox_(run),
      mailboxes_(run, mailbox_, bits),
      sm2_(run, mailbox_, events),
      evidence_(run),
      inputs_(run),
      frames_(kMostFrames) {}

PendingFrame& AcyclicScheduler::clear() {
  for (auto& frame : frames_) frame.clear();
  carrier_ = nullptr;
  return frames_.front();
}

/// A mailbox may fill a frame of its own.
bool AcyclicScheduler::add(Datagram& datagram) { return frames_[0].add(datagram) || frames_[1].add(datagram); }

void AcyclicScheduler::fill(std::span<Datagram* const> waiting, const Room& room, Nanoseconds now) {
  mailboxes_.add_to(frames_.front(), now);
  sm2_.begin(now);
  add_request(room, now);
  auto* own = mailbox_.next(now);
  mailbox_asked_ = own != nullptr && add(*own);
  add_waiting(waiting, room);
  // Whoever waits for an answer goes first, and evidence takes one datagram a cycle.
  evidence_asked_ = false;
  if (inputs_.add_to(frames_.front())) return;
  auto* evidence = evidence_.next(now);
  evidence_asked_ = evidence != nullptr && frames_.front().add(*evidence);
}

/// In a cycle that it would burst it waits for the next; one that is too long for every cycle is refused.
void AcyclicScheduler::add_request(const Room& room, Nanoseconds now) {
  request_asked_ = false;
  auto* datagram = requests_.next(now);
  if (datagram == nullptr) return;
  const auto needed = wire_time_ns(size_of(*datagram) + kFrameOverhead);
  const auto left = latest_return(room.cycle_time) - room.cyclic_wire_time;
  if (needed > left) {
    requests_.refuse_asked(
        {.code = ErrorCode::kNotSupported,
         .why = brief("its datagram of {bytes} bytes takes {time} us on the wire, and the cycle leaves "
                      "no room for it; choose a longer cycle",
                      datagram->data.size(), needed / kMicrosecond)});
    return;
  }
  request_asked_ = needed + wire_time() <= left && add(*datagram);
}

/// What would not come back in time is left for the next cycle; one request a cycle goes in any case. Where nothing
/// comes back in time, it is the host that is slow, and not the number of bytes.
void AcyclicScheduler::add_waiting(std::span<Datagram* const> waiting, const Room& room) {
  auto left = latest_return(room.cycle_time) - room.travel - room.cyclic_wire_time - wire_time();
  const bool limited = left > 0;
  std::size_t frame = 0;
  for (auto* request : waiting) {
    left -= static_cast<Nanoseconds>(size_of(*request)) * kWireByteTime;
    if (limited && left < 0 && request != waiting.front()) break;
    while (frame < limit_ && !frames_[frame].add(*request)) ++frame;
    if (frame == limit_) break;
  }
}

void AcyclicScheduler::ride(PendingFrame& cyclic) {
  auto& own = frames_.front();
  if (own.empty() || !frames_[1].empty() || own.size() > kLongestRide || !cyclic.has_room(own)) return;
  for (auto* datagram : own.datagrams()) (void)cyclic.add(*datagram);
  own.clear();
  carrier_ = &cyclic;
}

const PendingFrame* AcyclicScheduler::sent(const PendingFrame& frame) const {
  if (!frame.empty()) return &frame;
  return &frame == &frames_.front() ? carrier_ : nullptr;
}

Nanoseconds AcyclicScheduler::wire_time() const {
  Nanoseconds sum = 0;
  for (const auto& frame : frames_) {
    if (!frame.empty()) sum += wire_time_ns(frame.size() + kFrameOverhead);
  }
  return sum;
}

/// A bus with many slaves has many requests, and how many frames a cycle can carry depends on the host,
/// the wire and the length of the segment: found by trying.
void AcyclicScheduler::adapt(Nanoseconds scheduled, Nanoseconds cycle_time) {
  std::size_t count = 0;
  bool all_back = true;
  Nanoseconds last = scheduled;
  for (const auto& own : frames_) {
    const auto* frame = sent(own);
    if (frame == nullptr) continue;
    ++count;
    all_back = all_back && frame->answered();
    last = std::max(last, frame->arrival_time());
  }
  if (!all_back) {
    limit_ = std::max<std::size_t>(1, limit_ / 2);
  } else if (count == limit_ && last < scheduled + cycle_time / 2) {
    limit_ = std::min(limit_ + 1, kMostFrames);
  }
}

bool AcyclicScheduler::take_mailboxes(Nanoseconds time, CycleSample& sample) {
  mailboxes_.take_polls();
  if (std::exchange(request_asked_, false)) requests_.take(time);
  requests_.settle(time);
  if (std::exchange(mailbox_asked_, false)) mailbox_.take(time);
  const auto answer = mailbox_.answer();
  if (!answer) return false;
  sm2_.take(*answer, time, sample);
  mailboxes_.take(*answer, time);
  return answer->emergency;
}

void AcyclicScheduler::take_evidence(Nanoseconds time, bool read) {
  if (std::exchange(evidence_asked_, false)) evidence_.take(time);
  inputs_.take(time, read);
}

}  // namespace syncline
