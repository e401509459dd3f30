// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "config/mailbox_description.h"
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
/// An IDN as soe::idn_text() writes it, or as a number of 16 bits; nothing for what is neither.
[[nodiscard]] std::optional<std::uint16_t> parse_idn(std::string_view text);

}  // namespace syncline::settings
