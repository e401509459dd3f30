// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "support/types.h"

namespace syncline {

/// The thread of this host that keeps a processor longest at a time, of those that real-time priority does not
/// interrupt. A plain value without memory of its own, so that it crosses from thread to thread.
struct ProcessorHolder {
  std::array<char, 32> name{};  // as /proc names it; empty: nobody is known
  bool kernel = false;          // a thread of the kernel; else one of a program with as much priority as the master's
  Nanoseconds at_a_time = 0;    // in the mean, since the run began
  std::uint64_t times = 0;      // how often
  [[nodiscard]] bool known() const { return name.front() != '\0'; }
  [[nodiscard]] std::string_view name_text() const { return name.data(); }
  bool operator==(const ProcessorHolder&) const = default;
};

// LatestBox asks; a holder has no memory of its own.
[[nodiscard]] inline std::size_t room_of(const ProcessorHolder&) { return 0; }
inline void make_room(ProcessorHolder&, std::size_t) {}

}  // namespace syncline
