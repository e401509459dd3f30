// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace syncline {

struct SignalInfo;

/// The rows of each slave in the table of signals.
[[nodiscard]] std::span<const SignalInfo> slave_signals();

}  // namespace syncline
