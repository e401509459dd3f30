// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
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
/// Events of the slave (misses, outputs too late for SYNC0) that fall into a time in which its SYNC0, or the clock that
/// it follows, was out of its place by as much as it takes for outputs to come too late: they are the clock's doing.
/// Nothing when most of them do not.
[[nodiscard]] std::optional<MovedSync0> sync0_had_moved(const RunReport& report, const RunReport::Slave& slave,
                                                        const Spells& events);
/// The same of one moment, host clock: MovedSync0::why.
[[nodiscard]] std::optional<std::string_view> sync0_had_moved_at(const RunReport& report, const RunReport::Slave& slave,
                                                                 Nanoseconds moment);

}  // namespace syncline::diagnosis
