// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/mailbox_description.h"
#include "protocol/al_state.h"
#include "support/result.h"

namespace syncline::settings {

/// "PS,SP 0x6060:00=08 complete fixed off adapt timeout=500 # comment": transitions, object, data in wire order
/// (hexadecimal), then the options that are set. The comment is everything behind " # ".
[[nodiscard]] std::string format_startup(const StartupCommand& command);
/// kBadValue with what is wrong in it; the subject stays empty.
[[nodiscard]] Result<StartupCommand> parse_startup(std::string_view text);

/// As format_startup() for SoE: "PS 0:S-0-0047=0a00 fixed off timeout=500 # comment"; drive, IDN, data in wire order.
[[nodiscard]] std::string format_soe(const SoeCommand& command);
[[nodiscard]] Result<SoeCommand> parse_soe(std::string_view text);

// Parts of these.
/// What stands between a command and its comment.
inline constexpr std::string_view kCommentMark = " # ";
/// Takes the next word off the front of `text`; "" at its end.
[[nodiscard]] std::string_view next_word(std::string_view& text);
[[nodiscard]] std::string format_transitions(const std::vector<Transition>& transitions);
[[nodiscard]] Status parse_transitions(std::string_view text, std::vector<Transition>& transitions);
[[nodiscard]] Result<std::vector<std::uint8_t>> parse_hex_data(std::string_view digits);

}  // namespace syncline::settings
