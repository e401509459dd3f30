// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <cstddef>
#include <span>

#include "support/types.h"

namespace syncline {
struct Finding;
class RunRecord;
struct SyncLamp;
struct SyncOverview;
}  // namespace syncline

namespace syncline::ui {

/// What one of the lamps says below its state: for how long, and when it was lost last.
[[nodiscard]] QString lampText(const SyncLamp& lamp, const SyncOverview& overview);
/// What came first in an episode of the log and what followed, and what of all episodes is not over, as rich text whose
/// links are moments of the run (host clock, ns). Where nothing happened, the worst of what was found nevertheless.
[[nodiscard]] QString firstFaultText(const RunRecord& record, std::span<const Finding> findings, std::size_t episode);
/// The most severe warning or error that was not over by then (host clock); null: there is none.
[[nodiscard]] const Finding* worstOf(std::span<const Finding> findings, Nanoseconds since);
/// A moment as the plots' axis has it: "12.345 s" since the first sample.
[[nodiscard]] QString momentText(Nanoseconds time, const RunRecord& record);

}  // namespace syncline::ui
