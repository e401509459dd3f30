// SPDX-License-Identifier: Apache-2.0
#include "master/channels.h"

#include <bit>
#include <utility>

namespace syncline {

SampleRing::SampleRing(std::size_t capacity)
    : slots_(std::bit_ceil(capacity < 2 ? std::size_t{2} : capacity)), mask_(slots_.size() - 1) {}

bool SampleRing::push(const CycleSample& sample) {
  const auto head = head_.load(std::memory_order_relaxed);
  if (head - tail_.load(std::memory_order_acquire) == slots_.size()) {
    overruns_.fetch_add(1, std::memory_order_relaxed);
    return false;
  }
  slots_[head & mask_] = sample;
  head_.store(head + 1, std::memory_order_release);
  return true;
}

std::size_t SampleRing::pop(std::vector<CycleSample>& out, std::size_t at_most) {
  const auto tail = tail_.load(std::memory_order_relaxed);
  const auto available = head_.load(std::memory_order_acquire) - tail;
  const auto count = available < at_most ? available : at_most;
  out.reserve(out.size() + count);
  for (std::size_t i = 0; i < count; ++i) out.push_back(slots_[(tail + i) & mask_]);
  tail_.store(tail + count, std::memory_order_release);
  return count;
}

void SnapshotBox::publish(const Snapshot& snapshot) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return;
  latest_ = snapshot;
  fresh_ = true;
}

void SnapshotBox::publish_surely(const Snapshot& snapshot) {
  const std::scoped_lock lock(mutex_);
  latest_ = snapshot;
  fresh_ = true;
}

bool SnapshotBox::read(Snapshot& out) {
  const std::scoped_lock lock(mutex_);
  if (!fresh_) return false;
  out = latest_;
  fresh_ = false;
  return true;
}

EventQueue::EventQueue(std::size_t capacity) : capacity_(capacity) { events_.reserve(capacity); }

void EventQueue::push(Event event) {
  const std::scoped_lock lock(mutex_);
  if (events_.size() >= capacity_) {
    ++lost_;
    return;
  }
  events_.push_back(std::move(event));
}

std::vector<Event> EventQueue::drain() {
  {
    const std::scoped_lock lock(mutex_);
    if (events_.empty() && lost_ == 0) return {};
  }
  // Allocated outside the lock, so that the cyclic thread never waits for the allocator.
  std::vector<Event> out;
  out.reserve(capacity_ + 1);
  std::uint64_t lost = 0;
  {
    const std::scoped_lock lock(mutex_);
    out.swap(events_);
    lost = std::exchange(lost_, 0);
  }
  if (lost > 0) {
    Event event;
    event.kind = EventKind::kEventsLost;
    event.time = out.empty() ? 0 : out.back().time;
    event.a = static_cast<std::int64_t>(lost);
    out.push_back(std::move(event));
  }
  return out;
}

void CommandQueue::push(MasterCommand command) {
  const std::scoped_lock lock(mutex_);
  commands_.push_back(std::move(command));
}

bool CommandQueue::empty() {
  const std::scoped_lock lock(mutex_);
  return commands_.empty();
}

std::optional<MasterCommand> CommandQueue::pop() {
  const std::scoped_lock lock(mutex_);
  if (commands_.empty()) return std::nullopt;
  auto command = std::move(commands_.front());
  commands_.erase(commands_.begin());
  return command;
}

}  // namespace syncline
