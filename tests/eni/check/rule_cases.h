// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "config/network_config.h"

namespace syncline::test {

/// A machine that is right but for one thing, and what the checker says about it.
struct RuleCase {
  std::string code;
  std::function<void(NetworkConfig&)> break_it;
  /// Findings that cannot be kept apart from it.
  std::set<std::string> companions = {};
  bool twincat = false;
};

/// The same for a text that our writer would not write.
struct TextCase {
  std::string code;
  std::function<std::string(std::string)> break_it;
};

[[nodiscard]] std::vector<RuleCase> slave_cases();
[[nodiscard]] std::vector<RuleCase> command_cases();
[[nodiscard]] std::vector<RuleCase> clock_cases();
[[nodiscard]] std::vector<RuleCase> image_cases();
[[nodiscard]] std::vector<RuleCase> device_cases();
[[nodiscard]] std::vector<TextCase> text_cases();

}  // namespace syncline::test
