// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace syncline {

/// What a thread with deadlines asks of the system, for the calling thread while the object lives:
/// SCHED_FIFO, memory that stays in RAM, a touched stack, and a processor that does not fall into deep sleep
/// (the PM QoS device; leaving a deep idle state costs tens of microseconds). What the system refuses is told,
/// and the thread runs without it. Memory stays locked when the object goes.
class RealTimeScope {
 public:
  /// Above threaded interrupts (50), below the kernel's own threads.
  static constexpr int kDefaultPriority = 80;

  explicit RealTimeScope(int priority = kDefaultPriority);
  ~RealTimeScope();
  RealTimeScope(const RealTimeScope&) = delete;
  RealTimeScope& operator=(const RealTimeScope&) = delete;

  /// What was not granted, in words with the system's reason; empty when all was.
  [[nodiscard]] const std::string& refused() const { return refused_; }

 private:
  void note(const char* what, int error);

  std::string refused_;
  int latency_fd_ = -1;
};

/// The priority of the calling thread under SCHED_FIFO or SCHED_RR; 0 when it has none.
[[nodiscard]] int real_time_priority();
/// Takes it from the calling thread, which may have it from the one that started it.
void give_up_real_time();

/// Binds the calling thread to one processor; the system's reason when that is refused, else empty.
[[nodiscard]] std::string bind_to_processor(unsigned cpu);

}  // namespace syncline
