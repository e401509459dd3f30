// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace syncline {

enum class CheckSeverity : std::uint8_t { kNote, kWarning, kError };
[[nodiscard]] std::string_view severity_name(CheckSeverity severity);  // "note", "warning", "error"

/// A rule of the ENI checker. Codes are stable: one that is no longer used is not given to another rule.
struct CheckRule {
  std::string_view code;  // "ENI-DC-03"
  CheckSeverity severity = CheckSeverity::kNote;
  std::string_view title;  // what is found
  std::string_view why;    // what goes wrong on the machine
  std::string_view mend;   // what to do about it
};

/// All rules in the order of docs/check.md: by family, then by number.
[[nodiscard]] std::span<const CheckRule> check_rules();
/// The rule of a code; every finding's code has one.
[[nodiscard]] const CheckRule* find_check_rule(std::string_view code);

}  // namespace syncline
