// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "channels/event.h"

namespace syncline {

/// Bounded; overflow drops the newest and later delivers kEventsLost with the count. The cyclic path
/// uses it only on changes, never each cycle.
class EventQueue {
 public:
  explicit EventQueue(std::size_t capacity = 4096);
  void push(Event event);
  std::vector<Event> drain();

 private:
  std::mutex mutex_;
  std::vector<Event> events_;
  std::size_t capacity_;
  std::uint64_t lost_ = 0;
};

}  // namespace syncline
