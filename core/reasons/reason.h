// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace syncline {

/// Why something fails or is refused, as a value: a row of the table of reasons (reason_words.h) with what stands in
/// its placeholders, which because() looks up while compiling; or a text that is not ours. Nothing but text() makes a
/// sentence of it, and the window says the row in its language.
class Reason {
 public:
  static constexpr std::uint16_t kNoRow = 0xFFFF;

  Reason() = default;
  /// What others say as they say it: SQLite, a slave, a file, a command.
  [[nodiscard]] static Reason verbatim(std::string text) { return Reason(kNoRow, std::move(text), false); }
  /// A sentence of ours would be a row.
  template <std::size_t kSize>
  static Reason verbatim(const char (&)[kSize]) = delete;
  /// What some of the world says in its own words which translations know all the same: the system's errors, the
  /// meanings of codes, words of finding_phrases(). Another text stays as it is.
  [[nodiscard]] static Reason phrase(std::string_view text) { return Reason(kNoRow, std::string(text), true); }
  /// The system's words for an errno.
  [[nodiscard]] static Reason of_system(int number);
  /// The row of this number with as many things as it has placeholders: see because().
  [[nodiscard]] static Reason of_row(std::uint16_t row, std::vector<Reason> given) {
    return Reason(row, std::move(given));
  }
  /// A sentence of another table that translations know, with what stands in its placeholders: see reason_of() in
  /// core/findings.
  [[nodiscard]] static Reason of_words(std::string_view words, std::vector<Reason> given) {
    auto reason = phrase(words);
    reason.given_ = std::move(given);
    return reason;
  }

  [[nodiscard]] bool empty() const { return row_ == kNoRow && text_.empty(); }
  /// English.
  [[nodiscard]] std::string text() const;
  /// The row with its {placeholders}; the text itself where it is a phrase; nothing where no language changes it.
  [[nodiscard]] std::string_view words() const;
  /// What stands in the placeholders, in their order.
  [[nodiscard]] std::span<const Reason> given() const { return given_; }
  bool operator==(const Reason&) const = default;

 private:
  Reason(std::uint16_t row, std::string text, bool phrase) : row_(row), phrase_(phrase), text_(std::move(text)) {}
  Reason(std::uint16_t row, std::vector<Reason> given) : row_(row), given_(std::move(given)) {}

  std::uint16_t row_ = kNoRow;
  bool phrase_ = false;
  std::string text_{};
  std::vector<Reason> given_{};
};

/// The reason whose words() and given() these are, as they were written down: a phrase where nothing is given. Nothing
/// where the table has no such row any more.
[[nodiscard]] std::optional<Reason> reason_of_words(std::string_view words, std::vector<Reason> given);

}  // namespace syncline
