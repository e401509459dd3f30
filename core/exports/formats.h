// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace syncline {
struct NetworkConfig;
}  // namespace syncline

namespace syncline::exports {

/// A kind of file that is made of a configuration beside the ENI (exports.h).
struct Format {
  std::string_view name;    // of the command line: "c-header"
  std::string_view suffix;  // of its files, with the point
  std::string_view what;    // in a few words, English
  /// Its text; `file`: name of the file without folder and suffix.
  std::string (*text)(const NetworkConfig& config, const std::string& file);
};

/// All of them, in the order in which they are offered.
[[nodiscard]] std::span<const Format> formats();
/// Null when there is none of that name.
[[nodiscard]] const Format* find_format(std::string_view name);

}  // namespace syncline::exports
