// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "trace/signals.h"

namespace syncline {

/// The one table of signals, by their ids; bus and slaves put their rows into it.
using SignalTable = std::array<SignalInfo, kSignalCount>;
inline void put_signal(SignalTable& table, const SignalInfo& row) { table[static_cast<std::size_t>(row.id)] = row; }

}  // namespace syncline
