// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/types.h"

namespace syncline {

/// How long and how often a thread has had a processor since it began.
struct ThreadRun {
  std::int64_t id = 0;
  std::string name{};
  bool kernel = false;
  Nanoseconds ran = 0;
  std::uint64_t slices = 0;
};

/// The threads that one of SCHED_FIFO with `priority` may have to wait for once they run: the kernel's own, which a
/// kernel without preemption interrupts for nobody, and those of other programs with at least that priority. From
/// /proc/PID/stat and schedstat (proc(5); kernel: Documentation/scheduler/sched-stats): some milliseconds of processor
/// time, and it allocates. Threads that end meanwhile are left out.
[[nodiscard]] std::vector<ThreadRun> hard_threads(int priority, const std::filesystem::path& proc = "/proc");

/// Who of `after` ran longest at a time since `before`, in the mean; `ran` and `slices` are those since then. Empty
/// where nobody ran at all.
[[nodiscard]] std::optional<ThreadRun> longest_at_a_time(std::span<const ThreadRun> before,
                                                         std::span<const ThreadRun> after);

}  // namespace syncline
