// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "config/sim_config.h"

namespace syncline::sim {

/// How long frames take through an ESC. Data sheets give ranges; these are values in them (docs/scenarios.md), and what
/// a master has to get along with is that they differ.
struct EscType {
  std::string_view name;
  std::uint8_t type_register;  // 0x0000
  EscDelays delays;
};
/// Null when there is none of that name.
[[nodiscard]] const EscType* find_esc_type(std::string_view name);
/// All of them, for an error message.
[[nodiscard]] std::string esc_type_names();

}  // namespace syncline::sim
