// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "trace/signal_quality.h"

namespace syncline::ui {

/// What one has to know of a signal before one believes it, in clauses: "1,000 readings a second; newest 0.4 ms old;
/// by the clocks of the slaves, ±10 ns; moment stamped by the kernel, within 2.4 us". What is not known is left out.
[[nodiscard]] QString qualityText(const SignalQuality& quality);

}  // namespace syncline::ui
