// SPDX-License-Identifier: Apache-2.0
#include "link/fault_link.h"

#include <algorithm>
#include <vector>

#include "support/clock.h"
#include "support/random.h"

namespace syncline {
namespace {

/// A frame that is to come behind the next one does not wait for ever when none follows.
constexpr Nanoseconds kLongestReorder = 1 * kMillisecond;

struct HeldFrame {
  Nanoseconds due = 0;
  bool behind_next = false;
  std::vector<std::uint8_t> bytes;
};

}  // namespace

struct FaultLink::Impl {
  Impl(std::unique_ptr<Link> inner_link, Clock& own_clock, const LinkFaults& own_faults)
      : inner(std::move(inner_link)), clock(own_clock), faults(own_faults), random(own_faults.seed) {}

  bool happens(double probability) { return probability > 0 && random.uniform() < probability; }

  void hold(std::span<const std::uint8_t> frame, Nanoseconds due, bool behind_next) {
    held.push_back({due, behind_next, {frame.begin(), frame.end()}});
  }
  [[nodiscard]] Nanoseconds next_due(Nanoseconds deadline) const {
    for (const auto& frame : held) deadline = std::min(deadline, frame.due);
    return deadline;
  }
  ReceivedFrame deliver_held(std::span<std::uint8_t> buffer) {
    const auto now = clock.now();
    const auto due = std::ranges::find_if(held, [now](const auto& frame) { return frame.due <= now; });
    if (due == held.end()) return {};
    const auto length = std::min(due->bytes.size(), buffer.size());
    std::copy_n(due->bytes.begin(), length, buffer.begin());
    held.erase(due);
    return {length, now};
  }
  /// True when the frame is to be delivered now.
  bool passes(std::span<const std::uint8_t> frame) {
    if (happens(faults.lose_reply)) {
      ++injected.lost;
      return false;
    }
    if (happens(faults.late)) {
      ++injected.late;
      hold(frame, clock.now() + faults.late_by, false);
      return false;
    }
    if (happens(faults.reorder)) {
      ++injected.reordered;
      hold(frame, clock.now() + kLongestReorder, true);
      return false;
    }
    for (auto& waiting : held) {
      if (waiting.behind_next) waiting.due = clock.now();
    }
    if (happens(faults.duplicate)) {
      ++injected.duplicated;
      hold(frame, clock.now(), false);
    }
    return true;
  }

  std::unique_ptr<Link> inner;
  Clock& clock;
  LinkFaults faults;
  Random random;
  Injected injected;
  std::vector<HeldFrame> held;
};

FaultLink::FaultLink(std::unique_ptr<Link> inner, Clock& clock, const LinkFaults& faults)
    : impl_(std::make_unique<Impl>(std::move(inner), clock, faults)) {}
FaultLink::~FaultLink() = default;

void FaultLink::set_faults(const LinkFaults& faults) {
  impl_->faults = faults;
  impl_->random = Random(faults.seed);
}

const FaultLink::Injected& FaultLink::injected() const { return impl_->injected; }

Status FaultLink::send(std::span<const std::uint8_t> frame) {
  ++impl_->injected.sent;
  if (impl_->happens(impl_->faults.lose_request)) {
    ++impl_->injected.lost;
    return {};
  }
  return impl_->inner->send(frame);
}

std::optional<Nanoseconds> FaultLink::sent_at() const { return impl_->inner->sent_at(); }

Result<Nanoseconds> FaultLink::send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) {
  ++impl_->injected.sent;
  if (impl_->happens(impl_->faults.lose_request)) {
    ++impl_->injected.lost;
    return field.send_time;
  }
  return impl_->inner->send_corrected(frame, field);
}

Result<ReceivedFrame> FaultLink::receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) {
  for (;;) {
    if (const auto held = impl_->deliver_held(buffer); held.length > 0) return held;
    auto received = impl_->inner->receive(buffer, impl_->next_due(deadline));
    if (!received) return received;
    if (received->length > 0) {
      if (impl_->passes(buffer.first(received->length))) return received;
    } else if (impl_->clock.now() >= deadline && impl_->next_due(deadline) >= deadline) {
      return ReceivedFrame{};
    }
  }
}

LinkDescription FaultLink::describe() const { return impl_->inner->describe(); }

}  // namespace syncline
