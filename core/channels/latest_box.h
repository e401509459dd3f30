// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace syncline {

/// The latest of something, from one thread to one other; older ones are lost. Three slots change hands: neither side
/// ever waits, and the reader always gets the newest. The slots keep the capacity that T has, so that publishing does
/// not allocate once publish_first() has made room. Beside T stand `room_of(const T&)`, how much it holds, and
/// `make_room(T&, std::size_t)`, which reserves so much.
template <class T>
class LatestBox {
 public:
  /// Writer: the thread that runs the cycle.
  void publish(const T& value) {
    slots_[back_] = value;
    const auto mine = static_cast<std::uint8_t>(back_ | kFresh);
    back_ = middle_.exchange(mine, std::memory_order_acq_rel) & kSlot;
  }
  /// The same where it may allocate, for a value with other sizes than before: makes room in every slot.
  void publish_first(const T& value) {
    room_.store(room_of(value), std::memory_order_relaxed);
    publish(value);
    publish(value);  // into the slot that lay between
  }
  /// Copies the latest; false when nothing new came since the last call. Reader.
  bool read(T& out) {
    if (taken()) return false;
    make_room(slots_[front_], room_.load(std::memory_order_relaxed));
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kSlot;
    out = slots_[front_];
    return true;
  }
  /// The last one has been read: somebody is waiting for the next. Writer.
  [[nodiscard]] bool taken() const { return (middle_.load(std::memory_order_relaxed) & kFresh) == 0; }

 private:
  static constexpr std::uint8_t kFresh = 4, kSlot = 3;

  std::array<T, 3> slots_;
  std::uint8_t back_ = 0;                // the writer's
  std::uint8_t front_ = 1;               // the reader's
  std::atomic<std::uint8_t> middle_{2};  // between them, and whether the reader has seen it
  std::atomic<std::size_t> room_{0};     // that the slot must have which the reader gives back
};

}  // namespace syncline
