// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trace/signals.h"

namespace syncline::ui {

struct StateText;

/// A value of a signal that is a state (SignalInfo::Scale::kBand), in words and tone: "SAFEOP + ERR", "In sync",
/// "Port 0, PDI watchdog".
[[nodiscard]] StateText stateText(Signal signal, int value);

}  // namespace syncline::ui
