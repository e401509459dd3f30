// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace syncline {
struct Identity;
}  // namespace syncline

namespace syncline::eni {

/// What somebody who searches says of numbers, taken out of his words.
struct RevisionWords {
  /// Both ends count.
  struct Range {
    std::uint32_t first = 0, last = UINT32_MAX;
    bool operator==(const Range&) const = default;
  };
  std::string words{};                   // what is left
  std::vector<std::uint32_t> numbers{};  // "#x00120000": product code or revision of the device, each of them
  std::optional<Range> revisions{};      // "rev 18", "rev 16-18", "rev 16-", "rev #x00100000-#x00120000"
  bool operator==(const RevisionWords&) const = default;

  [[nodiscard]] bool none() const { return numbers.empty() && !revisions; }
  [[nodiscard]] bool fit(const Identity& identity) const;
  /// They mean this revision and not only the product.
  [[nodiscard]] bool name_revision(const Identity& identity) const;
};

/// A number of eight hexadecimal digits behind #x or 0x is a whole product code or revision. Behind "rev" or
/// "revision", hexadecimal numbers are whole revisions; a decimal one up to 65535 is the revision's high word, as
/// vendors print it on devices ("-0018" is #x00120000), or a revision as small as that. What is none of it stays a
/// word.
[[nodiscard]] RevisionWords revision_words(std::string_view words);

}  // namespace syncline::eni
