// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/stop_signals.h"

namespace syncline::cli {

/// Around whatever touches a bus, so that it is left in order and the report printed.
using InterruptGuard = StopSignals;

}  // namespace syncline::cli
