// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "channels/values/delay_warning.h"

namespace syncline {

struct Event;
struct Finding;

/// What an event says: a row of core/findings/event_words.h with its figures, or that of the error it tells. Nothing
/// for progress, which only programs care about.
[[nodiscard]] std::optional<Finding> event_finding(const Event& event);

/// What the measurement of the delays stumbled over at a slave; value: ns, or a port, see DelayWarning.
[[nodiscard]] Finding delay_finding(int slave, dc::DelayWarning warning, std::int64_t value);

}  // namespace syncline
