// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "master/exchange/frame_exchange.h"

namespace syncline {

/// Exchanges any number of datagrams without a bus cycle: as many a frame as fit, several frames on the
/// wire at once. A frame that does not come back is repeated by itself, with twice the patience each
/// time; what has been answered stays answered.
class AcyclicWindow {
 public:
  /// Frames on the wire at once: 2 ms of a 100 Mbit/s wire when all are full, far fewer than indexes.
  static constexpr std::size_t kFrames = 16;

  explicit AcyclicWindow(FrameExchange& exchange) : exchange_(exchange) {}

  /// Returns when every datagram is answered, or was lost and must not be repeated (Datagram::once and the
  /// commands that read and write). kNoResponse when a frame is lost again and again, the error of
  /// `check` when that has one, errors of the link.
  Status exchange(std::span<Datagram> datagrams, const std::function<Status()>& check);

 private:
  struct Slot {
    PendingFrame frame;
    Nanoseconds deadline = 0;
    int losses = 0;
  };

  bool fill(Slot& slot);
  Status send(Slot& slot);
  Status send_new();
  Status repeat_lost();
  Status run(const std::function<Status()>& check);

  FrameExchange& exchange_;
  std::unique_ptr<std::array<Slot, kFrames>> slots_;  // made at the first use: cyclic operation needs none
  std::array<PendingFrame*, kFrames> frames_{};
  std::span<Datagram> open_;  // not sent yet
  std::size_t window_ = kFrames;
};

/// False for what a slave must not execute twice: commands that read and write in one go.
[[nodiscard]] bool may_repeat(const Datagram& datagram);

}  // namespace syncline
