// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/bus.h"

#include <algorithm>

#include "protocol/datagram.h"

namespace syncline {
namespace {

/// With bus cycles: no answer for so long, and for so many cycles, is no burst of lost frames any more.
constexpr Nanoseconds kBusPatience = 100 * kMillisecond;
constexpr int kBusTries = 5;
constexpr Nanoseconds kLinkPause = 20 * kMillisecond;

}  // namespace

Status Bus::check_cancel() const {
  if (!cancellable_) return {};
  const bool cancelled = cancel_ != nullptr && cancel_->load(std::memory_order_relaxed);
  if (cancelled || (interrupt_ && interrupt_())) return fail(ErrorCode::kCancelled);
  return {};
}

Status Bus::transact(std::span<Datagram> datagrams) {
  for (auto& datagram : datagrams) {
    datagram.answered = false;
    datagram.wkc = 0;
    datagram.times_sent = 0;
  }
  if (pump_ != nullptr) return ride_with_cycles(datagrams);
  const auto check = [this] { return check_cancel(); };
  auto status = window_.exchange(datagrams, check);
  note_link(status);
  if (status || status.error().code != ErrorCode::kLinkDown) return status;
  status = await_link(datagrams, std::move(status));
  note_link(status);
  return status;
}

void Bus::note_link(const Status& status) const {
  const bool down = !status && status.error().code == ErrorCode::kLinkDown;
  if (link_observer_ && (status || down)) link_observer_(!down);
}

/// The adapter is away, perhaps for a moment: what it has not carried goes out when it is back.
Status Bus::await_link(std::span<Datagram> datagrams, Status status) {
  const auto end = clock_.now() + kLinkPatience;
  const auto is_open = [](const Datagram& datagram) {
    return !datagram.answered && (datagram.times_sent == 0 || may_repeat(datagram));
  };
  while (!status && status.error().code == ErrorCode::kLinkDown && clock_.now() < end) {
    if (auto cancelled = check_cancel(); !cancelled) return cancelled;
    clock_.sleep_until(clock_.now() + kLinkPause);
    status = {};
    for (auto& datagram : datagrams) {
      if (!is_open(datagram)) continue;
      status = window_.exchange(std::span(&datagram, 1), [this] { return check_cancel(); });
      if (!status) break;
    }
  }
  return status;
}

Status Bus::ride_with_cycles(std::span<Datagram> datagrams) {
  open_.clear();
  for (auto& datagram : datagrams) open_.push_back(&datagram);
  int tries_left = kBusTries;
  auto patience_ends = clock_.now() + kBusPatience;
  while (!open_.empty()) {
    if (auto status = check_cancel(); !status) return status;
    const auto before = open_.size();
    if (auto status = pump_->run_cycle(open_); !status) return status;
    std::erase_if(open_, [](const auto* datagram) {
      return datagram->answered || (datagram->times_sent > 0 && !may_repeat(*datagram));
    });
    if (open_.size() < before) {
      tries_left = kBusTries;
      patience_ends = clock_.now() + kBusPatience;
    } else if (--tries_left <= 0 && clock_.now() >= patience_ends) {
      return fail(ErrorCode::kNoResponse, exchange_.link().describe().name);
    }
  }
  return {};
}

Status Bus::wait(Nanoseconds duration) {
  const auto end = clock_.now() + duration;
  do {
    if (auto status = check_cancel(); !status) return status;
    if (pump_ != nullptr) {
      if (auto status = pump_->run_cycle({}); !status) return status;
    } else {
      clock_.sleep_until(std::min(end, clock_.now() + 5 * kMillisecond));
    }
  } while (clock_.now() < end);
  return {};
}

Status Bus::wait_a_little() { return wait(pump_ != nullptr ? 1 : kMillisecond); }

Result<std::uint16_t> Bus::exchange(Command command, std::uint16_t adp, std::uint16_t ado,
                                    std::span<std::uint8_t> data) {
  Datagram datagram{command, device_address(adp, ado), data};
  if (auto status = transact(datagram); !status) return tl::unexpected(status.error());
  return datagram.wkc;
}

}  // namespace syncline
