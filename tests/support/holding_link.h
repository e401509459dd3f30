// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "link/link.h"
#include "support/clock.h"

namespace syncline::test {

/// Frames that are sent between `from` and `to` (since the start) reach the bus `longer` later; or, `coming_back` then,
/// the master.
struct HeldSpan {
  Nanoseconds from = 0, to = 0, longer = 0;
  bool coming_back = false;
};

/// A card or a switch that holds frames up on their way to the bus, or back; their order stays.
class HoldingLink final : public Link {
 public:
  HoldingLink(std::unique_ptr<Link> inner, Clock& clock, std::vector<HeldSpan> spans)
      : inner_(std::move(inner)), clock_(clock), spans_(std::move(spans)), begin_(clock.now()) {}

  Status send(std::span<const std::uint8_t> frame) override {
    if (auto passed_on = pass_on(); !passed_on) return passed_on;
    holds_ = holds_next();
    if (!holds_) return inner_->send(frame);
    hold(held_, clock_.now() + held_now(false), frame);
    return {};
  }

  /// Whatever holds it up does so behind who puts the time into it.
  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) override {
    if (auto passed_on = pass_on(); !passed_on) return tl::unexpected(passed_on.error());
    holds_ = holds_next();
    if (!holds_) return inner_->send_corrected(frame, field);
    hold(held_, clock_.now() + held_now(false), frame);
    return clock_.now();
  }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override {
    return holds_ ? std::nullopt : inner_->sent_at();
  }

  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    for (;;) {
      if (auto passed_on = pass_on(); !passed_on) return tl::unexpected(passed_on.error());
      if (!returning_.empty() && returning_.front().due <= clock_.now()) {
        const auto frame = std::move(returning_.front());
        returning_.pop_front();
        std::ranges::copy(frame.bytes, buffer.begin());
        return ReceivedFrame{frame.bytes.size(), frame.due};
      }
      auto until = deadline;
      for (const auto* held : {&held_, &returning_}) {
        if (!held->empty()) until = std::min(until, held->front().due);
      }
      auto received = inner_->receive(buffer, until);
      if (!received) return received;
      if (received->length == 0) {
        if (until == deadline) return received;
        continue;
      }
      const auto longer = held_now(true);
      if (longer == 0 && returning_.empty()) return received;
      hold(returning_, received->arrival_time + longer, buffer.first(received->length));
    }
  }

  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  struct Held {
    Nanoseconds due = 0;
    std::vector<std::uint8_t> bytes;
  };
  [[nodiscard]] bool holds_next() const { return held_now(false) > 0 || !held_.empty(); }
  [[nodiscard]] Nanoseconds held_now(bool coming_back) const {
    const auto now = clock_.now() - begin_;
    const auto span = std::ranges::find_if(
        spans_, [&](const auto& s) { return s.coming_back == coming_back && now >= s.from && now < s.to; });
    return span == spans_.end() ? 0 : span->longer;
  }
  static void hold(std::deque<Held>& held, Nanoseconds due, std::span<const std::uint8_t> frame) {
    held.push_back({held.empty() ? due : std::max(due, held.back().due), {frame.begin(), frame.end()}});
  }
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
  bool holds_ = false;  // the frame that was sent last
  std::deque<Held> held_{}, returning_{};
};

}  // namespace syncline::test
