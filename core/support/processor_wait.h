// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "support/types.h"

namespace syncline {

/// How long the calling thread has been ready to run while others had its processor, since it began: the second number
/// of /proc/thread-self/schedstat (kernel: Documentation/scheduler/sched-stats). Tells a thread that was kept waiting
/// from one whose timer came late. Use each object in one thread only; take() is one system call, allocates nothing and
/// waits for nothing.
class ProcessorWait {
 public:
  ProcessorWait() = default;
  ~ProcessorWait();
  ProcessorWait(const ProcessorWait&) = delete;
  ProcessorWait& operator=(const ProcessorWait&) = delete;

  /// Empty where the kernel does not count it.
  [[nodiscard]] std::optional<Nanoseconds> take();

 private:
  int file_ = -1;
  bool refused_ = false;
};

/// The second of the numbers of a schedstat line; empty when there is none.
[[nodiscard]] std::optional<Nanoseconds> wait_of_schedstat(const char* line);

}  // namespace syncline
