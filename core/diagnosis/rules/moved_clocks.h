// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "trace/run_report.h"

namespace syncline::diagnosis {

/// Why a slave's SYNC0 did not come where its outputs are meant for.
struct MovedSync0 {
  std::string_view why;       // one of finding_phrases(): goes behind a colon
  Nanoseconds since = 0;      // host clock
  std::uint64_t counted = 0;  // of the events that were asked about, so many then
};
/// Events of the slave (misses, outputs too late for SYNC0) that fall into a time in which its clock, or the one that
/// it follows, was out of its place: they are the clock's doing. Nothing when most of them do not.
[[nodiscard]] std::optional<MovedSync0> sync0_had_moved(const RunReport& report, int slave, const Spells& events);

}  // namespace syncline::diagnosis
