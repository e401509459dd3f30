// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <readerwriterqueue/readerwritercircularbuffer.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

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
  // Of the library's two queues the one whose hand-over ThreadSanitizer understands; nobody waits in it.
  moodycamel::BlockingReaderWriterCircularBuffer<Event> events_;
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace syncline
