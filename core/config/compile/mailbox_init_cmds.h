// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "config/compile/slave_plan.h"

namespace syncline::compiler {

/// Adds the start-up messages of EoE, SoE and AoE: those of the ESI and those that the user's settings make.
void add_mailbox_init_cmds(MailboxConfig& mailbox, const SlavePlan& slave);

/// "192.168.1.10" in the order of the text; empty when it is no such address.
[[nodiscard]] std::optional<std::array<std::uint8_t, 4>> ipv4_bytes(std::string_view text);

/// Six numbers 0..255 with dots.
[[nodiscard]] std::optional<std::array<std::uint8_t, 6>> ams_net_id_bytes(std::string_view text);

}  // namespace syncline::compiler
