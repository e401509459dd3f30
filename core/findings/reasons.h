// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Sentences that were made where something was found (Error::detail), taken apart again so that
/// they can be said in another language.
namespace syncline {

struct Reason {
  std::string_view words;  // a row of reason_words.h, with {placeholders}
  std::vector<std::pair<std::string_view, std::string>>
      given{};  // what stands in them, in their order; {reason} is one, too
  bool operator==(const Reason&) const = default;
};

/// Nothing where the text is somebody's own, or has no row.
[[nodiscard]] std::optional<Reason> find_reason(std::string_view text);

}  // namespace syncline
