// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "link/link.h"
#include "support/clock.h"

namespace syncline::test {

/// Frames that are sent between `from` and `to` (since the start) reach the bus `longer` later.
struct HeldSpan {
  Nanoseconds from = 0, to = 0, longer = 0;
};

/// A card or a switch that holds frames up on their way to the bus; their order stays.
class HoldingLink final : public Link {
 public:
  HoldingLink(std::unique_ptr<Link> inner, Clock& clock, std::vector<HeldSpan> spans)
      : inner_(std::move(inner)), clock_(clock), spans_(std::move(spans)), begin_(clock.now()) {}

  Status send(std::span<const std::uint8_t> frame) override {
    if (auto passed_on = pass_on(); !passed_on) return passed_on;
    const auto now = clock_.now() - begin_;
    const auto span = std::ranges::find_if(spans_, [now](const auto& s) { return now >= s.from && now < s.to; });
    if (span == spans_.end() && held_.empty()) return inner_->send(frame);
    const auto due = clock_.now() + (span == spans_.end() ? 0 : span->longer);
    held_.push_back({held_.empty() ? due : std::max(due, held_.back().due), {frame.begin(), frame.end()}});
    return {};
  }

  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    for (;;) {
      if (auto passed_on = pass_on(); !passed_on) return tl::unexpected(passed_on.error());
      const auto until = held_.empty() ? deadline : std::min(deadline, held_.front().due);
      auto received = inner_->receive(buffer, until);
      if (!received || received->length > 0 || until == deadline) return received;
    }
  }

  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  struct Held {
    Nanoseconds due = 0;
    std::vector<std::uint8_t> bytes;
  };
  Status pass_on() {
    for (; !held_.empty() && held_.front().due <= clock_.now(); held_.pop_front()) {
      if (auto sent = inner_->send(held_.front().bytes); !sent) return sent;
    }
    return {};
  }
  std::unique_ptr<Link> inner_;
  Clock& clock_;
  std::vector<HeldSpan> spans_;
  Nanoseconds begin_;
  std::deque<Held> held_{};
};

}  // namespace syncline::test
