// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "check/check_rule.h"

/// The texts of the rules, by family.
namespace syncline::checker {

[[nodiscard]] std::span<const CheckRule> structure_rules();
[[nodiscard]] std::span<const CheckRule> slave_rules();
[[nodiscard]] std::span<const CheckRule> commands_rules();
[[nodiscard]] std::span<const CheckRule> cyclic_rules();
[[nodiscard]] std::span<const CheckRule> image_rules();
[[nodiscard]] std::span<const CheckRule> device_rules();

}  // namespace syncline::checker
