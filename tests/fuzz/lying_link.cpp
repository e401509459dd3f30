// SPDX-License-Identifier: Apache-2.0
#include "fuzz/lying_link.h"

#include <algorithm>

namespace syncline::fuzz {
namespace {

enum Lie : std::uint8_t { kDamage, kShorten, kDatagram, kDatagramAgain, kTwice, kLater, kLost, kMadeUp, kCount };
constexpr std::uint8_t kHonest = 0x80;  // half of the frames

}  // namespace

void LyingLink::lie_in_datagram(std::span<std::uint8_t> frame) {
  FrameReader reader(frame);
  auto skip = script_.byte() % 4;
  for (auto datagram = reader.next(); datagram; datagram = reader.next()) {
    if (skip-- > 0) continue;
    const auto what = script_.byte();
    if (what % 2 == 0) {
      datagram->set_wkc(what % 4 == 0 ? static_cast<std::uint16_t>(datagram->wkc() + 1) : script_.word());
    } else if (!datagram->data.empty()) {
      const auto from = script_.byte() % datagram->data.size();
      const auto data = script_.take(std::min<std::size_t>(what / 8U + 1U, datagram->data.size() - from));
      std::ranges::copy(data, datagram->data.begin() + static_cast<std::ptrdiff_t>(from));
    }
    return;
  }
}

bool LyingLink::lie(std::span<std::uint8_t> buffer, std::size_t& length) {
  const auto frame = buffer.first(length);
  const auto choice = script_.byte();
  if (choice < kHonest) return true;
  switch (static_cast<Lie>(choice % kCount)) {
    case kDamage:
      if (length > 0) frame[script_.word() % length] = script_.byte();
      return true;
    case kShorten:
      length = script_.word() % (length + 1);
      return length > 0;
    case kDatagram:
    case kDatagramAgain:
      lie_in_datagram(frame);
      return true;
    case kTwice:
      waiting_.emplace_back(frame.begin(), frame.end());
      return true;
    case kLater:
      waiting_.emplace_back(frame.begin(), frame.end());
      return false;
    case kMadeUp: {
      const auto bytes = script_.take(script_.byte());
      std::ranges::copy(bytes, buffer.begin());
      length = bytes.size();
      return length > 0;
    }
    case kLost:
    case kCount:
      break;
  }
  return false;
}

Result<ReceivedFrame> LyingLink::receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) {
  for (;;) {
    auto received = inner_->receive(buffer, deadline);
    if (!received) return received;
    if (received->length == 0) {
      if (waiting_.empty()) return received;
      const auto& next = waiting_.front();
      std::ranges::copy(next, buffer.begin());
      received->length = next.size();
      received->arrival_time = deadline;
      waiting_.pop_front();
      return received;
    }
    if (script_.over() || lie(buffer, received->length)) return received;
  }
}

}  // namespace syncline::fuzz
