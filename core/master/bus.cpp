// SPDX-License-Identifier: Apache-2.0
#include "master/bus.h"

#include <algorithm>

namespace syncline {
namespace {

/// A frame that is not back by now is lost: the longest segment needs a fraction of it.
constexpr Nanoseconds kReplyTimeout = 10 * kMillisecond;
constexpr int kTries = 4;

}  // namespace

Status Bus::check_cancel() const {
  if (cancellable_ && cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) {
    return fail(ErrorCode::kCancelled);
  }
  return {};
}

Status Bus::send_now(std::span<Datagram* const> open) {
  frame_.clear();
  for (auto* datagram : open) {
    if (!frame_.add(*datagram)) break;
  }
  if (auto status = exchange_.send(frame_); !status) return status;
  PendingFrame* frames[] = {&frame_};
  return exchange_.collect(frames, frame_.send_time() + kReplyTimeout);
}

Status Bus::transact(std::span<Datagram> datagrams) {
  open_.clear();
  for (auto& datagram : datagrams) {
    datagram.answered = false;
    open_.push_back(&datagram);
  }
  int tries_left = kTries;
  while (!open_.empty()) {
    if (auto status = check_cancel(); !status) return status;
    const auto before = open_.size();
    if (auto status = pump_ != nullptr ? pump_->run_cycle(open_) : send_now(open_); !status) return status;
    std::erase_if(open_, [](const auto* datagram) { return datagram->answered; });
    if (open_.size() < before) {
      tries_left = kTries;
    } else if (--tries_left == 0) {
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
