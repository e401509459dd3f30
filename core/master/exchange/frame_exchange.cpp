// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/frame_exchange.h"

#include <algorithm>

#include "protocol/datagram.h"

namespace syncline {
namespace {

/// No frame is on its way for longer: hosts and switches that stall for a second drop what they hold.
constexpr Nanoseconds kIndexRest = 1 * kSecond;

/// The answer to what was sent: slaves count the ADP of device addresses up and change no other address.
bool same_request(const DatagramView& view, const Datagram& sent) {
  if (view.header.command != sent.command || view.data.size() != sent.data.size()) return false;
  const bool counted = is_auto_increment(sent.command) || is_broadcast(sent.command);
  const std::uint32_t mask = counted ? 0xFFFF'0000U : 0xFFFF'FFFFU;
  return ((view.header.address ^ sent.address) & mask) == 0;
}

}  // namespace

void PendingFrame::clear() {
  count_ = 0;
  bytes_ = 0;
  capacity_ = kMostBytes;
  in_flight_ = false;
  answered_ = false;
}

bool PendingFrame::add(Datagram& datagram) {
  const std::size_t size = kDatagramOverhead + datagram.data.size();
  if (count_ == kMaxDatagrams || bytes_ + size > capacity_) return false;
  datagram.answered = false;
  datagram.wkc = 0;
  datagrams_[count_++] = &datagram;
  bytes_ += size;
  return true;
}

bool PendingFrame::has_room(const PendingFrame& other) const {
  return count_ + other.count_ <= kMaxDatagrams && bytes_ + other.bytes_ <= capacity_;
}

void FrameExchange::set_addresses(const MacAddress& destination, const MacAddress& source) {
  builder_.set_addresses(destination, source);
}

Status FrameExchange::send(PendingFrame& frame, SendStamp* stamp) {
  builder_.reset();
  frame.index_ = take_index(clock_.now());
  frame.sequence_ = ++sequence_;
  missing_.forget(frame.index_);
  std::size_t stamped = 0;
  std::span<const std::uint8_t> corrected;
  for (auto* datagram : frame.datagrams()) {
    if (datagram->times_sent < 0xFF) ++datagram->times_sent;
    const auto area = builder_.add(datagram->command, frame.index_, datagram->address, datagram->data);
    if (datagram->stamped && area && stamped < kMaxStamped) stamped_areas_[stamped++] = *area;
    if (datagram->corrected_by_link && datagram->command != Command::kNop && area) corrected = *area;
  }
  frame.answered_ = false;
  const auto bytes = builder_.finish();
  frame.send_time_ = clock_.now();
  frame.stamped_by_ = StampSource::kSoftware;
  if (stamp != nullptr) {
    stamp->stamp(frame.send_time_);
    refill_stamped(frame);
  }
  auto status = hand_over(frame, bytes, corrected);
  frame.in_flight_ = status.has_value();
  if (frame.in_flight_) index_rests_until_[frame.index_] = frame.send_time_ + kIndexRest;
  return status;
}

Status FrameExchange::hand_over(PendingFrame& frame, std::span<const std::uint8_t> bytes,
                                std::span<const std::uint8_t> corrected) {
  if (corrected.empty()) {
    auto status = link_.send(bytes);
    if (const auto left = link_.sent_at()) {
      frame.send_time_ = *left;
      frame.stamped_by_ = StampSource::kKernel;
    }
    return status;
  }
  const auto offset = static_cast<std::size_t>(corrected.data() - bytes.data());
  const auto left = link_.send_corrected(bytes, {offset, corrected.size(), frame.send_time_});
  if (!left) return tl::unexpected(left.error());
  frame.send_time_ = *left;
  frame.stamped_by_ = StampSource::kAdapter;
  return {};
}

std::uint8_t FrameExchange::take_index(Nanoseconds now) {
  // When all of them rest, the bus is dead; the next one has then rested longest.
  for (int tried = 0; tried < 256 && index_rests_until_[next_index_] > now; ++tried) ++next_index_;
  return next_index_++;
}

void FrameExchange::refill_stamped(const PendingFrame& frame) {
  std::size_t next = 0;
  for (const auto* datagram : frame.datagrams()) {
    if (!datagram->stamped || next == kMaxStamped) continue;
    std::ranges::copy(datagram->data, stamped_areas_[next++].begin());
  }
}

Status FrameExchange::collect(std::span<PendingFrame* const> frames, Nanoseconds deadline) {
  Status status;
  while (std::ranges::any_of(frames, &PendingFrame::in_flight)) {
    const auto received = receive(frames, deadline);
    if (!received) status = tl::unexpected(received.error());
    if (!received || !*received) break;
  }
  for (auto* frame : frames) {
    if (frame->in_flight_) miss(*frame, deadline);
  }
  return status;
}

void FrameExchange::miss(PendingFrame& frame, Nanoseconds deadline) {
  const auto& first = *frame.datagrams().front();
  missing_.miss(frame.index_, {frame.sequence_, frame.send_time_, deadline, first.command, first.address,
                               first.data.size(), frame.cyclic_});
  give_up(frame);
}

Result<bool> FrameExchange::receive(std::span<PendingFrame* const> frames, Nanoseconds deadline) {
  const auto received = link_.receive(buffer_, deadline);
  if (!received) return tl::unexpected(received.error());
  if (received->length == 0) return false;
  if (!dispatch(frames, *received)) ++stray_;
  return true;
}

void FrameExchange::give_up(PendingFrame& frame) {
  if (frame.in_flight_) ++lost_;
  frame.in_flight_ = false;
}

bool FrameExchange::dispatch(std::span<PendingFrame* const> frames, const ReceivedFrame& received) {
  const auto bytes = std::span(buffer_).first(received.length);
  FrameReader reader(bytes);
  const auto first = reader.next();
  if (!first) return false;
  for (auto* frame : frames) {
    if (!frame->in_flight_ || frame->index_ != first->header.index) continue;
    if (!accept(*frame, bytes)) return false;
    frame->arrival_time_ = received.arrival_time;
    missing_.returned(frame->sequence_);
    return true;
  }
  if (!missing_.take_late(first->header, received.arrival_time)) return false;
  index_rests_until_[first->header.index] = 0;  // nothing with it is on its way any more
  return true;
}

bool FrameExchange::accept(PendingFrame& frame, std::span<std::uint8_t> bytes) {
  // Two walks: nothing is taken over from a frame that is not ours from end to end.
  FrameReader check(bytes);
  for (const auto* datagram : frame.datagrams()) {
    const auto view = check.next();
    if (!view || view->header.index != frame.index_ || !same_request(*view, *datagram)) return false;
  }
  FrameReader reader(bytes);
  for (auto* datagram : frame.datagrams()) {
    const auto view = reader.next();
    std::ranges::copy(view->data, datagram->data.begin());
    datagram->wkc = view->wkc();
    datagram->answered = true;
  }
  frame.in_flight_ = false;
  frame.answered_ = true;
  index_rests_until_[frame.index_] = 0;
  return true;
}

}  // namespace syncline
