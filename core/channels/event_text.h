// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace syncline {

struct Event;
struct Finding;

/// What an event says, in English, with the advice behind it and without the time; it begins with "slave N" where it is
/// about one. "" for events that only programs care about. Command line, recordings and black boxes have these words.
[[nodiscard]] std::string event_words(const Event& event);
/// The same where event_finding() of it is known.
[[nodiscard]] std::string event_words(const Event& event, const Finding& finding);

}  // namespace syncline
