// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "channels/snapshot.h"

namespace syncline {

/// The latest snapshot, from one thread to one other; older ones are lost. Three slots change hands: neither side ever
/// waits, and the reader always gets the newest. The slots keep the capacity of their vectors, so that publishing does
/// not allocate once publish_first() has made room.
class SnapshotBox {
 public:
  void publish(const Snapshot& snapshot);  // writer: the thread that runs the cycle
  /// The same where it may allocate, for a snapshot with other slaves than before: makes room in every slot.
  void publish_first(const Snapshot& snapshot);
  /// Copies the latest snapshot; false when nothing new came since the last call. Reader.
  bool read(Snapshot& out);
  /// The last one has been read: somebody is waiting for the next. Writer.
  [[nodiscard]] bool taken() const { return (middle_.load(std::memory_order_relaxed) & kFresh) == 0; }

 private:
  static constexpr std::uint8_t kFresh = 4, kSlot = 3;

  std::array<Snapshot, 3> slots_;
  std::uint8_t back_ = 0;                // the writer's
  std::uint8_t front_ = 1;               // the reader's
  std::atomic<std::uint8_t> middle_{2};  // between them, and whether the reader has seen it
  std::atomic<std::size_t> slaves_{0};   // for which the slot that the reader gives back must have room
};

}  // namespace syncline
