// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace syncline {

/// Values in their order, from one thread to one other: a ring of `capacity` places, made at construction
/// (std::bad_alloc). Neither side waits, allocates, or asks the other for more than how far it is; what is in a value
/// goes with it to who takes it.
template <class Value>
class BoundedQueue {
  static_assert(std::is_nothrow_move_constructible_v<Value> && std::is_nothrow_destructible_v<Value>);

 public:
  explicit BoundedQueue(std::size_t capacity) : places_(capacity) {}
  ~BoundedQueue() {
    while (pop()) {
    }
  }
  BoundedQueue(const BoundedQueue&) = delete;
  BoundedQueue& operator=(const BoundedQueue&) = delete;

  /// Producer. False when it is full: `value` stays as it is.
  bool push(Value&& value) {
    const auto written = written_.load(std::memory_order_relaxed);
    if (written - taken_.load(std::memory_order_acquire) == places_.size()) return false;
    std::construct_at(&place(written).value, std::move(value));
    written_.store(written + 1, std::memory_order_release);
    return true;
  }
  /// Consumer. Nothing when it is empty.
  std::optional<Value> pop() {
    const auto taken = taken_.load(std::memory_order_relaxed);
    if (taken == written_.load(std::memory_order_acquire)) return std::nullopt;
    auto& value = place(taken).value;
    std::optional<Value> out(std::move(value));
    std::destroy_at(&value);
    taken_.store(taken + 1, std::memory_order_release);
    return out;
  }
  /// Of either side, at a moment that has passed for the other.
  [[nodiscard]] bool empty() const {
    return taken_.load(std::memory_order_acquire) == written_.load(std::memory_order_acquire);
  }
  [[nodiscard]] std::size_t capacity() const { return places_.size(); }

 private:
  /// Room for a value, which whoever pushes makes and whoever takes ends.
  union Place {
    Place() {}   // NOLINT(modernize-use-equals-default): it would be deleted where a value has a constructor
    ~Place() {}  // NOLINT(modernize-use-equals-default)
    Value value;
  };
  Place& place(std::size_t number) { return places_[number % places_.size()]; }

  static constexpr std::size_t kCacheLine = 64;
  std::vector<Place> places_;
  // Each is written by one side alone; on a line of its own, so that neither takes the other's away. They only grow.
  alignas(kCacheLine) std::atomic<std::size_t> written_{0};
  alignas(kCacheLine) std::atomic<std::size_t> taken_{0};
};

}  // namespace syncline
