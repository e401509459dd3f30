// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace syncline {

struct Event;
struct RecordedEvent;

/// As recordings hold it, in English; nothing for events that only programs care about.
[[nodiscard]] std::optional<RecordedEvent> recorded_event(const Event& event);

}  // namespace syncline
