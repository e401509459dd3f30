// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "channels/event.h"

/// Events and findings as values in a recording, beside their words: who opens it has what the run had, in every
/// language. Nothing where the bytes are none, or those of a newer program.
namespace syncline {

struct Finding;

[[nodiscard]] std::string encode_event(const EventDetails& what);
[[nodiscard]] std::optional<EventDetails> decode_event(std::string_view bytes);

[[nodiscard]] std::string encode_finding(const Finding& finding);
[[nodiscard]] std::optional<Finding> decode_finding(std::string_view bytes);

}  // namespace syncline
