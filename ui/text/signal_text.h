// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "trace/signals.h"

namespace syncline::ui {

/// Name of a signal that has a value of its own in every cycle or reading, as a distribution needs it; empty for counts
/// and states.
[[nodiscard]] QString signalText(Signal signal);

}  // namespace syncline::ui
