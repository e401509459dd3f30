// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/acyclic_scheduler.h"

#include <algorithm>
#include <utility>

#include "channels/cycle_sample.h"
#include "channels/master_channels.h"
#include "config/frame_time.h"
#include "master/cyclic/cyclic_frame_set.h"
#include "master/cyclic/mailbox_bits.h"
#include "master/cyclic/sync_event_watch.h"
#include "master/exchange/run_state.h"
#include "reasons/brief_reason.h"

namespace syncline {
namespace {

constexpr std::size_t kMostFrames = 8;
/// As long as the shortest frame of its own keeps the wire busy: 64 bytes, preamble and gap. Outputs are valid, and
/// inputs come back, later by no more than that, 6.7 us.
constexpr std::size_t kLongestRide = 84;
/// What outputs must have left for that, and for fewer bytes accordingly less.
constexpr Nanoseconds kRoomToRide = 30 * kMicrosecond;

/// Room that a cycle has for one short datagram, whatever is left of it: registers of 16 bytes, deviations, AL states.
constexpr std::size_t kLeast = 28;
constexpr unsigned kMostHeldUp = 8;  // cycles

std::size_t size_of(const Datagram& datagram) { return kDatagramOverhead + datagram.data.size(); }

bool may_ride(std::size_t bytes, Nanoseconds room) {
  return room >= kRoomToRide * static_cast<Nanoseconds>(bytes) / Nanoseconds{kLongestRide};
}

/// One short datagram alone, 1 us: nothing is known of the process data of the whole machine without.
bool may_ride_alone(const Datagram& datagram, Nanoseconds room) {
  return room >= 2 * static_cast<Nanoseconds>(size_of(datagram)) * kWireByteTime;
}

/// Of datagrams in a frame that keeps the wire busy for so long.
std::size_t bytes_within(Nanoseconds time) {
  constexpr Nanoseconds kEmpty = wire_time_ns(kMinEthernetFrame);
  if (time < kEmpty) return 0;
  const auto more = static_cast<std::size_t>((time - kEmpty) / kWireByteTime);
  return kMinEthernetFrame + more - kFrameOverhead;
}

}  // namespace

AcyclicScheduler::AcyclicScheduler(RunState& run, const MailboxBits& bits, SyncEventWatch& events)
    : requests_(run.config(), run.snapshot, run.mailboxes, run.channels().requests),
      mailbox_(run.snapshot, run.mailboxes),
      mailboxes_(run.config(), run.mailboxes, mailbox_, bits),
      sm2_(run.config(), run.snapshot, run.teller, mailbox_, events),
      evidence_(run.config(), run.snapshot, run.teller),
      process_data_(run.config(), run.snapshot, run.teller),
      frames_(kMostFrames) {}

PendingFrame& AcyclicScheduler::clear(const Room& room) {
  for (auto& frame : frames_) frame.clear();
  carrier_ = nullptr;
  left_ = latest_return(room.cycle_time) - room.travel - room.cyclic_wire_time;
  return bounded(0);
}

/// The frame, to be filled with no more than comes back in time beside the others. The first one always takes a short
/// datagram. Where nothing comes back in time, it is the host that is slow, and not the number of bytes.
PendingFrame& AcyclicScheduler::bounded(std::size_t index) {
  auto& frame = frames_[index];
  if (left_ <= 0) return frame;
  const auto own = frame.empty() ? 0 : wire_time_ns(frame.size() + kFrameOverhead);
  frame.set_capacity(std::max(bytes_within(left_ - wire_time() + own), index == 0 ? kLeast : 0));
  return frame;
}

/// A mailbox may fill a frame of its own.
bool AcyclicScheduler::add(Datagram& datagram) { return bounded(0).add(datagram) || bounded(1).add(datagram); }

void AcyclicScheduler::fill(std::span<Datagram* const> waiting, Nanoseconds now) {
  mailboxes_.add_to(bounded(0), now);
  sm2_.begin(now);
  add_request(now);
  auto* own = mailbox_.next(now);
  mailbox_asked_ = own != nullptr && add(*own);
  add_waiting(waiting);
  // Whoever waits for an answer goes first, and evidence takes one datagram a cycle.
  evidence_asked_ = false;
  looked_after_ = process_data_.next();
  if (looked_after_) return;
  auto* evidence = evidence_.next(now);
  evidence_asked_ = evidence != nullptr && bounded(0).add(*evidence);
}

/// In a cycle that it would burst it waits for the next; one that is too long for every cycle is refused.
void AcyclicScheduler::add_request(Nanoseconds now) {
  request_asked_ = false;
  auto* datagram = requests_.next(now);
  if (datagram == nullptr) return;
  const auto size = size_of(*datagram);
  if (left_ > 0 && size > std::max(bytes_within(left_), kLeast)) {
    requests_.refuse_asked(
        {.code = ErrorCode::kNotSupported,
         .why = brief("its datagram of {bytes} bytes takes {time} us on the wire, and the cycle leaves "
                      "no room for it; choose a longer cycle",
                      datagram->data.size(), wire_time_ns(size + kFrameOverhead) / kMicrosecond)});
    return;
  }
  request_asked_ = add(*datagram);
}

/// What would not come back in time is left for the next cycle.
void AcyclicScheduler::add_waiting(std::span<Datagram* const> waiting) {
  std::size_t frame = 0, added = 0;
  for (auto* request : waiting) {
    if (!add_waiting_one(*request, frame)) break;
    ++added;
  }
  held_up_ = waiting.empty() || added > 0 ? 0 : held_up_ + 1;
  // One that no cycle has room for goes nevertheless: the way that was learned may be longer than it is, and whoever
  // waits ends by his own time limit and not by our guess.
  if (held_up_ < kMostHeldUp) return;
  held_up_ = 0;
  frames_[0].set_capacity(PendingFrame::kMostBytes);
  (void)frames_[0].add(*waiting.front());
}

bool AcyclicScheduler::add_waiting_one(Datagram& request, std::size_t& frame) {
  while (frame < limit_ && !bounded(frame).add(request)) ++frame;
  return frame < limit_;
}

void AcyclicScheduler::ride(CyclicFrameSet& cyclic, Nanoseconds room) {
  if (cyclic.frames().empty()) return;
  ride_whole(*cyclic.frames().back(), room);
  if (!looked_after_) return;
  auto* const frame = cyclic.frame_with(looked_after_->outputs, looked_after_->slave);
  const bool may = carrier_ != nullptr || may_ride_alone(*looked_after_->datagram, room);
  if (frame != nullptr && may) (void)frame->add(*looked_after_->datagram);
}

/// Not where there is room for the one that is looked after alone: everything else may travel in a frame of its own.
void AcyclicScheduler::ride_whole(PendingFrame& cyclic, Nanoseconds room) {
  auto& own = frames_.front();
  const bool is_short = frames_[1].empty() && own.size() <= kLongestRide;
  const auto bytes = own.size() + (looked_after_ ? size_of(*looked_after_->datagram) : 0);
  if (own.empty() || !is_short || !may_ride(bytes, room) || !cyclic.has_room(own)) return;
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

bool AcyclicScheduler::take_mailboxes(Nanoseconds time, std::optional<Nanoseconds> reference_time,
                                      CycleSample& sample) {
  sm2_.sent(time, reference_time, (sample.flags & CycleSample::kFrameLate) != 0);
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

void AcyclicScheduler::take_evidence(Nanoseconds time, bool regular) {
  if (std::exchange(evidence_asked_, false)) evidence_.take(time);
  process_data_.take(time, regular);
}

}  // namespace syncline
