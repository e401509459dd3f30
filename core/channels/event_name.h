// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace syncline {

struct Event;

/// The "kind" of an event as docs/json.md lists it.
[[nodiscard]] std::string_view event_name(const Event& event);

}  // namespace syncline
