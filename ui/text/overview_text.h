// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "record/run_record.h"

namespace syncline::ui {

/// "Servo: Slave does not answer any more", with how often.
[[nodiscard]] QString faultText(const Fault& fault, const RunRecord& record);
/// What one of the lamps says below its state: for how long, and when it was lost last.
[[nodiscard]] QString lampText(const SyncLamp& lamp, const SyncOverview& overview);
/// What came first and what followed, as rich text whose links are moments of the run (host clock, ns).
[[nodiscard]] QString firstFaultText(const RunRecord& record);
/// A moment as the plots' axis has it: "12.345 s" since the first sample.
[[nodiscard]] QString momentText(Nanoseconds time, const RunRecord& record);

}  // namespace syncline::ui
