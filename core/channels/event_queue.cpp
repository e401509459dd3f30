// SPDX-License-Identifier: Apache-2.0
#include "channels/event_queue.h"

#include <utility>

namespace syncline {

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
    const auto time = out.empty() ? 0 : out.back().time;
    out.push_back({time, -1, events::EventsLost{lost}});
  }
  return out;
}

}  // namespace syncline
