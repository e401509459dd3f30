// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trace/signal_table.h"

namespace syncline {

/// Puts the rows of each slave into the table of signals.
void put_slave_signals(SignalTable& table);

}  // namespace syncline
