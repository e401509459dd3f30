// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "findings/event_bus_words.h"
#include "findings/event_slave_words.h"
#include "findings/joined_words.h"

namespace syncline::words {

/// What the master tells, by Event (core/channels); sentences begin small and have no full stop, as they stand behind a
/// time.
inline constexpr auto kEvents = joined(kEventBus, kEventSlaves);

}  // namespace syncline::words
