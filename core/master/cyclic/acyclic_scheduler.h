// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/cyclic/acyclic_requests.h"
#include "master/cyclic/cyclic_mailbox.h"
#include "master/cyclic/evidence_reader.h"
#include "master/cyclic/mailbox_watch.h"
#include "master/cyclic/process_data_watch.h"
#include "master/cyclic/sm2_reader.h"
#include "master/exchange/frame_exchange.h"

namespace syncline {

struct CycleSample;
class CyclicFrameSet;
class MailboxBits;
class RunState;
class SyncEventWatch;

/// Which acyclic datagrams ride with a bus cycle, in the order of their rank: short and regular readings of the slaves,
/// a datagram of the requests from outside, one of the master's own work in the mailboxes, as many as there is room for
/// of whoever holds the state machine up by waiting (Bus::transact()), and one of evidence. So requests never make a
/// cycle longer than by one datagram, and none goes whose bytes the rest of the cycle has no room for. Allocates
/// nothing in the cycle.
class AcyclicScheduler {
 public:
  AcyclicScheduler(RunState& run, const MailboxBits& bits, SyncEventWatch& events);

  [[nodiscard]] AcyclicRequests& requests() { return requests_; }
  [[nodiscard]] CyclicMailbox& mailbox() { return mailbox_; }
  [[nodiscard]] MailboxWatch& mailboxes() { return mailboxes_; }
  [[nodiscard]] Sm2Reader& sm2() { return sm2_; }

  /// A cycle and what its own frames take of it.
  struct Room {
    Nanoseconds cycle_time = 0;
    Nanoseconds cyclic_wire_time = 0;
    Nanoseconds travel = 0;  // through the segment and back
  };
  /// The first frame, empty, for who comes first of all. It takes what comes back in time, and something in any case.
  [[nodiscard]] PendingFrame& clear(const Room& room);
  /// Behind what is in there.
  void fill(std::span<Datagram* const> waiting, Nanoseconds now);
  [[nodiscard]] std::span<PendingFrame> frames() { return frames_; }
  /// When what goes in this cycle is short, it goes behind the commands of the last of the `cyclic` frames, and no
  /// frame of its own is sent: that would take longer on the wire, and the host twice as long. What looks after process
  /// data goes with these, or alone where there is no room for both. Neither where a slave has so little `room` for its
  /// outputs (SyncEventWatch::room()) that they must not come later in one cycle than in the other by so many bytes:
  /// they are valid with the end of their frame. Behind fill().
  void ride(CyclicFrameSet& cyclic, Nanoseconds room);
  /// Of all its frames.
  [[nodiscard]] Nanoseconds wire_time() const;
  /// After the frames are back, or not: how many the next cycle can carry.
  void adapt(Nanoseconds scheduled, Nanoseconds cycle_time);

  /// Takes over what came back of requests and mailboxes with the frames that were sent at `time`, and passed the
  /// reference clock at `reference_time` where that is known. True when a slave has sent an emergency.
  bool take_mailboxes(Nanoseconds time, std::optional<Nanoseconds> reference_time, CycleSample& sample);
  /// `regular`: no cycle was left out before this one.
  void take_evidence(Nanoseconds time, bool regular);

 private:
  bool add(Datagram& datagram);
  [[nodiscard]] PendingFrame& bounded(std::size_t index);
  /// The frame in which what is in this one was sent; null when it was not.
  [[nodiscard]] const PendingFrame* sent(const PendingFrame& frame) const;
  void ride_whole(PendingFrame& cyclic, Nanoseconds room);
  void add_request(Nanoseconds now);
  void add_waiting(std::span<Datagram* const> waiting);
  bool add_waiting_one(Datagram& request, std::size_t& frame);

  AcyclicRequests requests_;
  CyclicMailbox mailbox_;
  MailboxWatch mailboxes_;
  Sm2Reader sm2_;
  EvidenceReader evidence_;
  ProcessDataWatch process_data_;
  std::optional<ProcessDataWatch::Wish> looked_after_;
  std::vector<PendingFrame> frames_;
  Nanoseconds left_ = 0;                   // on the wire for the frames of this cycle
  unsigned held_up_ = 0;                   // cycles in which nothing of what waits found room
  const PendingFrame* carrier_ = nullptr;  // the cyclic frame that took the first one's place in this cycle
  std::size_t limit_ = 1;                  // frames a cycle, as many as come back in time
  bool request_asked_ = false, mailbox_asked_ = false, evidence_asked_ = false;
};

}  // namespace syncline
