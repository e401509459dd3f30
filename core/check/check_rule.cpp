// SPDX-License-Identifier: Apache-2.0
#include "check/check_rule.h"

#include <algorithm>
#include <vector>

#include "check/rule_tables.h"

namespace syncline {

std::string_view severity_name(CheckSeverity severity) {
  switch (severity) {
    case CheckSeverity::kNote:
      return "note";
    case CheckSeverity::kWarning:
      return "warning";
    case CheckSeverity::kError:
      return "error";
  }
  return "note";
}

std::span<const CheckRule> check_rules() {
  static const std::vector<CheckRule> rules = [] {
    std::vector<CheckRule> all;
    for (const auto table : {checker::structure_rules(), checker::slave_rules(), checker::commands_rules(),
                             checker::cyclic_rules(), checker::image_rules(), checker::device_rules()}) {
      all.insert(all.end(), table.begin(), table.end());
    }
    return all;
  }();
  return rules;
}

const CheckRule* find_check_rule(std::string_view code) {
  const auto rules = check_rules();
  const auto found = std::ranges::find(rules, code, &CheckRule::code);
  return found == rules.end() ? nullptr : &*found;
}

}  // namespace syncline
