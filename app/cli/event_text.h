// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/cli/json.h"
#include "support/types.h"

namespace syncline {
struct Event;
}  // namespace syncline

namespace syncline::cli {

/// One line for people, "" for events that only programs care about. Times are relative to `start`.
[[nodiscard]] std::string event_text(const Event& event, Nanoseconds start);
/// As docs/json.md describes it; null for events that only programs care about.
[[nodiscard]] Json event_json(const Event& event, Nanoseconds start);

}  // namespace syncline::cli
