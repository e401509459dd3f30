// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "trace/signals.h"

namespace syncline {

/// The rows of the bus in the table of signals.
[[nodiscard]] std::span<const SignalInfo> bus_signals();

}  // namespace syncline
