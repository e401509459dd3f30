// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/acyclic_window.h"

#include <algorithm>
#include <limits>

#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

/// Patience with a frame beyond the wire's own time. A host without real-time set-up sleeps for several
/// milliseconds now and then; a frame that is only late must not be repeated more often than needed.
constexpr Nanoseconds kReplyTimeout = 10 * kMillisecond;
constexpr int kWindowTries = 5;  // 10, 20, 40, 80, 160 ms
constexpr std::size_t kNarrowest = 2;
/// What waits in the host's buffers is looked at before a frame counts as lost, strange frames not for ever.
constexpr int kLateFrames = 64;

}  // namespace

bool may_repeat(const Datagram& datagram) {
  switch (datagram.command) {
    case Command::kAprw:
    case Command::kFprw:
    case Command::kBrw:
    case Command::kLrw:
    case Command::kArmw:
    case Command::kFrmw:
      return false;
    default:
      return !datagram.once;
  }
}

Status AcyclicWindow::exchange(std::span<Datagram> datagrams, const std::function<Status()>& check) {
  if (!slots_) {
    slots_ = std::make_unique<std::array<Slot, kFrames>>();
    for (std::size_t i = 0; i < kFrames; ++i) frames_[i] = &(*slots_)[i].frame;
  }
  open_ = datagrams;
  auto status = run(check);
  for (auto* frame : frames_) exchange_.give_up(*frame);
  return status;
}

Status AcyclicWindow::run(const std::function<Status()>& check) {
  for (int late = 0;;) {
    if (auto status = check(); !status) return status;
    if (auto status = send_new(); !status) return status;
    auto next = std::numeric_limits<Nanoseconds>::max();
    for (const auto& slot : *slots_) {
      if (slot.frame.in_flight()) next = std::min(next, slot.deadline);
    }
    if (next == std::numeric_limits<Nanoseconds>::max()) return {};
    const auto received = exchange_.receive(frames_, next);
    if (!received) return tl::unexpected(received.error());
    if (*received && (exchange_.clock().now() < next || ++late < kLateFrames)) {
      window_ = std::min(window_ + 1, kFrames);
      continue;
    }
    late = 0;
    if (auto status = repeat_lost(); !status) return status;
  }
}

bool AcyclicWindow::fill(Slot& slot) {
  slot.frame.clear();
  slot.losses = 0;
  while (!open_.empty() && slot.frame.add(open_.front())) open_ = open_.subspan(1);
  return !slot.frame.empty();
}

Status AcyclicWindow::send(Slot& slot) {
  if (auto status = exchange_.send(slot.frame); !status) return status;
  // All that is on the wire in front of it has to pass first.
  Nanoseconds load = 0;
  for (const auto& other : *slots_) {
    if (other.frame.in_flight()) load += wire_time_ns(other.frame.size() + kFrameOverhead);
  }
  slot.deadline = slot.frame.send_time() + load + (kReplyTimeout << slot.losses);
  return {};
}

Status AcyclicWindow::send_new() {
  auto in_flight = static_cast<std::size_t>(std::ranges::count_if(frames_, &PendingFrame::in_flight));
  for (auto& slot : *slots_) {
    if (open_.empty() || in_flight >= window_) return {};
    if (slot.frame.in_flight()) continue;
    if (!fill(slot)) return fail(ErrorCode::kMalformedData, "datagram", because("it is longer than a frame"));
    if (auto status = send(slot); !status) return status;
    ++in_flight;
  }
  return {};
}

Status AcyclicWindow::repeat_lost() {
  const auto now = exchange_.clock().now();
  for (auto& slot : *slots_) {
    if (!slot.frame.in_flight() || slot.deadline > now) continue;
    exchange_.give_up(slot.frame);
    // What gets lost may be too much at once for the host's buffers.
    window_ = std::max(window_ / 2, kNarrowest);
    std::array<Datagram*, PendingFrame::kMaxDatagrams> again{};
    const auto end = std::ranges::copy_if(slot.frame.datagrams(), again.begin(), [](const auto* datagram) {
                       return may_repeat(*datagram);
                     }).out;
    slot.frame.clear();
    if (end == again.begin()) continue;
    if (++slot.losses == kWindowTries) return fail(ErrorCode::kNoResponse, exchange_.link().describe().name);
    for (auto it = again.begin(); it != end; ++it) (void)slot.frame.add(**it);
    if (auto status = send(slot); !status) return status;
  }
  return {};
}

}  // namespace syncline
