// SPDX-License-Identifier: Apache-2.0
#include "master/frame_exchange.h"

#include <algorithm>

namespace syncline {
namespace {

constexpr std::size_t kFrameCapacity = kMaxEthernetFrame - kEthernetHeaderSize - kEtherCatHeaderSize;

}  // namespace

void PendingFrame::clear() {
  count_ = 0;
  bytes_ = 0;
  in_flight_ = false;
  answered_ = false;
}

bool PendingFrame::add(Datagram& datagram) {
  const std::size_t size = kDatagramHeaderSize + datagram.data.size() + kWkcSize;
  if (count_ == kMaxDatagrams || bytes_ + size > kFrameCapacity) return false;
  datagram.answered = false;
  datagram.wkc = 0;
  datagrams_[count_++] = &datagram;
  bytes_ += size;
  return true;
}

void FrameExchange::set_addresses(const MacAddress& destination, const MacAddress& source) {
  builder_.set_addresses(destination, source);
}

Status FrameExchange::send(PendingFrame& frame, SendStamp* stamp) {
  builder_.reset();
  frame.index_ = next_index_++;
  std::size_t stamped = 0;
  for (const auto* datagram : frame.datagrams()) {
    const auto area = builder_.add(datagram->command, frame.index_, datagram->address, datagram->data);
    if (datagram->stamped && area && stamped < kMaxStamped) stamped_areas_[stamped++] = *area;
  }
  frame.answered_ = false;
  const auto bytes = builder_.finish();
  frame.send_time_ = clock_.now();
  if (stamp != nullptr) {
    stamp->stamp(frame.send_time_);
    refill_stamped(frame);
  }
  auto status = link_.send(bytes);
  frame.in_flight_ = status.has_value();
  return status;
}

void FrameExchange::refill_stamped(const PendingFrame& frame) {
  std::size_t next = 0;
  for (const auto* datagram : frame.datagrams()) {
    if (!datagram->stamped || next == kMaxStamped) continue;
    std::ranges::copy(datagram->data, stamped_areas_[next++].begin());
  }
}

Status FrameExchange::collect(std::span<PendingFrame* const> frames, Nanoseconds deadline) {
  const auto waiting = [&] {
    return static_cast<std::uint64_t>(std::ranges::count_if(frames, [](const auto* f) { return f->in_flight_; }));
  };
  Status status;
  while (waiting() > 0) {
    const auto received = link_.receive(buffer_, deadline);
    if (!received) {
      status = tl::unexpected(received.error());
      break;
    }
    if (received->length == 0) break;
    if (!dispatch(frames, *received)) ++stray_;
  }
  lost_ += waiting();
  for (auto* frame : frames) frame->in_flight_ = false;
  return status;
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
    return true;
  }
  return false;
}

bool FrameExchange::accept(PendingFrame& frame, std::span<std::uint8_t> bytes) {
  // Two walks: nothing is taken over from a frame that is not ours from end to end.
  FrameReader check(bytes);
  for (const auto* datagram : frame.datagrams()) {
    const auto view = check.next();
    if (!view || view->header.command != datagram->command || view->header.index != frame.index_ ||
        view->data.size() != datagram->data.size()) {
      return false;
    }
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
  return true;
}

}  // namespace syncline
