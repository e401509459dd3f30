// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trace/signals.h"
#include "ui/text/sync_text.h"

namespace syncline::ui {

/// A value of a signal that is a state (SignalInfo::Scale::kBand), in words and tone: "SAFEOP + ERR", "In sync".
[[nodiscard]] StateText stateText(Signal signal, int value);

}  // namespace syncline::ui
