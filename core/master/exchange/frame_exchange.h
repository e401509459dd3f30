// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "channels/values/stamp_source.h"
#include "link/link.h"
#include "master/exchange/missing_frames.h"
#include "protocol/frame.h"
#include "support/clock.h"

namespace syncline {

/// One datagram to be exchanged; its memory belongs to whoever asks for it.
struct Datagram {
  Command command = Command::kNop;
  std::uint32_t address = 0;
  std::span<std::uint8_t> data;  // sent; overwritten by what comes back when answered
  std::uint16_t wkc = 0;
  bool answered = false;
  bool stamped = false;            // the data depend on the send time: SendStamp fills them
  bool corrected_by_link = false;  // a stamped time that the adapter corrects while it sends; one in a frame
  bool once = false;               // Bus::transact() never repeats it
  std::uint8_t times_sent = 0;     // above 1: an earlier copy may have been executed with its answer lost

  [[nodiscard]] bool done() const { return answered && wkc > 0; }
};

/// Fills datagrams whose data depend on the moment of sending. Called when the frame is built and
/// nothing but the link's send() is still to come, so that the stamp is as near to the wire as software
/// can be.
class SendStamp {
 public:
  virtual ~SendStamp() = default;
  virtual void stamp(Nanoseconds send_time) = 0;
};

/// One frame on its way with the datagrams in it. Allocates nothing.
class PendingFrame {
 public:
  static constexpr std::size_t kMaxDatagrams = 120;
  static constexpr std::size_t kMostBytes = kMaxDatagramBytes;

  void clear();
  /// False when the frame is full; the datagram then belongs into the next one.
  bool add(Datagram& datagram);
  /// So many bytes of datagrams from now on, as clear() gives them again; more than an Ethernet frame holds count as
  /// that.
  void set_capacity(std::size_t bytes) { capacity_ = std::min(bytes, kMostBytes); }
  /// For all that is in `other`.
  [[nodiscard]] bool has_room(const PendingFrame& other) const;
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// One of those that bring the slaves their process data; clear() leaves that as it is.
  void set_cyclic() { cyclic_ = true; }
  [[nodiscard]] std::span<Datagram* const> datagrams() const { return {datagrams_.data(), count_}; }
  [[nodiscard]] bool answered() const { return answered_; }
  [[nodiscard]] bool in_flight() const { return in_flight_; }
  /// Bytes of all datagrams with their headers and working counters.
  [[nodiscard]] std::size_t size() const { return bytes_; }
  /// Host clock when the driver got the frame, or just before it was handed to the link where nobody knows better; and
  /// when it came back.
  [[nodiscard]] Nanoseconds send_time() const { return send_time_; }
  [[nodiscard]] Nanoseconds arrival_time() const { return arrival_time_; }
  /// Whose send_time() is.
  [[nodiscard]] StampSource stamped_by() const { return stamped_by_; }

 private:
  friend class FrameExchange;
  std::array<Datagram*, kMaxDatagrams> datagrams_{};
  std::size_t count_ = 0;
  std::size_t bytes_ = 0, capacity_ = kMostBytes;
  std::uint8_t index_ = 0;
  std::uint64_t sequence_ = 0;
  bool in_flight_ = false;
  bool answered_ = false;
  bool cyclic_ = false;
  Nanoseconds send_time_ = 0, arrival_time_ = 0;
  StampSource stamped_by_ = StampSource::kUntold;
};

/// Puts datagrams on the wire and matches what comes back by the datagram index: every datagram of a
/// frame carries the frame's index. An index whose frame did not come back rests for a while, so that
/// the late frame is never taken for a newer one; what is matched must also have the commands, addresses and
/// lengths that were sent. A frame that collect() gave up and that comes while its index rests is late, not lost.
class FrameExchange {
 public:
  FrameExchange(Link& link, Clock& clock) : link_(link), clock_(clock) {}
  void set_addresses(const MacAddress& destination, const MacAddress& source);

  /// Builds, stamps and sends the frame. kLinkIo, kLinkDown from the link.
  Status send(PendingFrame& frame, SendStamp* stamp = nullptr);
  /// Receives until every frame that was sent is answered or `deadline` has passed; frames that are not
  /// back then are counted as lost, and as missing(). Replies that fit none of them are dropped and counted.
  Status collect(std::span<PendingFrame* const> frames, Nanoseconds deadline);
  /// Receives one frame of the wire, whether it fits one of `frames` or none; false when none came
  /// until `deadline`. Frames stay in flight until they are answered or given up.
  Result<bool> receive(std::span<PendingFrame* const> frames, Nanoseconds deadline);
  /// Counts the frame as lost; its index rests.
  void give_up(PendingFrame& frame);

  /// Not back in time, whatever came later.
  [[nodiscard]] std::uint64_t lost_frames() const { return lost_; }
  /// What became of those that collect() gave up.
  [[nodiscard]] MissingFrames& missing() { return missing_; }
  [[nodiscard]] std::uint64_t stray_frames() const { return stray_; }
  [[nodiscard]] Clock& clock() { return clock_; }
  [[nodiscard]] const Link& link() const { return link_; }

 private:
  static constexpr std::size_t kMaxStamped = 8;

  std::uint8_t take_index(Nanoseconds now);
  Status hand_over(PendingFrame& frame, std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> corrected);
  void refill_stamped(const PendingFrame& frame);
  void miss(PendingFrame& frame, Nanoseconds deadline);
  bool accept(PendingFrame& frame, std::span<std::uint8_t> bytes);
  bool dispatch(std::span<PendingFrame* const> frames, const ReceivedFrame& received);

  Link& link_;
  Clock& clock_;
  FrameBuilder builder_;
  std::array<std::uint8_t, 1536> buffer_{};
  std::array<std::span<std::uint8_t>, kMaxStamped> stamped_areas_{};
  std::uint8_t next_index_ = 0;
  std::array<Nanoseconds, 256> index_rests_until_{};
  MissingFrames missing_;
  std::uint64_t sequence_ = 0;
  std::uint64_t lost_ = 0, stray_ = 0;
};

}  // namespace syncline
