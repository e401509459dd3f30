// SPDX-License-Identifier: Apache-2.0
#include "app/cli/duration.h"

#include <charconv>

#include "app/cli/terminal_reason.h"

namespace syncline::cli {

Result<Nanoseconds> parse_duration(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  double scale = 0;
  if (unit.empty() || unit == "s") scale = 1e9;
  if (unit == "ms") scale = 1e6;
  if (unit == "us") scale = 1e3;
  if (unit == "min") scale = 60e9;
  if (unit == "h") scale = 3600e9;
  // Ten days: more is a slip of the keys, and keeps the product far inside 64 bit.
  if (error != std::errc{} || scale == 0 || !(value > 0) || value * scale > 864e12) {
    return fail(ErrorCode::kBadValue, std::string(text), in_terminal("use a duration such as 20s, 500ms or 2min"));
  }
  return static_cast<Nanoseconds>(value * scale);
}

}  // namespace syncline::cli
