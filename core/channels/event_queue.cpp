// SPDX-License-Identifier: Apache-2.0
#include "channels/event_queue.h"

#include <utility>

namespace syncline {

void EventQueue::push(Event event) {
  if (!events_.push(std::move(event))) lost_.fetch_add(1, std::memory_order_relaxed);
}

std::vector<Event> EventQueue::drain() {
  std::vector<Event> out;
  // No more than fit at once: a producer that never stops must not keep the consumer.
  while (out.size() < events_.capacity()) {
    auto event = events_.pop();
    if (!event) break;
    out.push_back(std::move(*event));
  }
  const auto lost = lost_.exchange(0, std::memory_order_relaxed);
  if (lost > 0) out.push_back({out.empty() ? 0 : out.back().time, -1, events::EventsLost{lost}});
  return out;
}

}  // namespace syncline
