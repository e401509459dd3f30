// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "channels/bounded_queue.h"
#include "channels/event.h"

namespace syncline {

/// Events in their order, from one thread to one other. Bounded: what does not fit is left out and counted, and the
/// count is told as events::EventsLost behind what came before. The producer neither waits nor allocates.
class EventQueue {
 public:
  explicit EventQueue(std::size_t capacity = 4096) : events_(capacity) {}
  void push(Event event);      // producer: the thread that runs the cycle
  std::vector<Event> drain();  // consumer

 private:
  BoundedQueue<Event> events_;
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace syncline
