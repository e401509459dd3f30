// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>

#include "reasons/because.h"
#include "support/result.h"
#include "support/types.h"

namespace syncline::sim {

/// Beyond, it is no clock.
inline constexpr double kMostPpm = 10'000;

/// Reads one table of a TOML file: every key that is asked for is remembered, the others are errors. The first error of
/// a file stands, with file, line and key; after it the values are of no use.
class Table {
 public:
  /// All three outlive it.
  Table(const toml::table& table, const std::string& file, std::optional<Error>& error)
      : table_(table), file_(file), error_(error) {}

  [[nodiscard]] std::string text(std::string_view key, std::string fallback);
  [[nodiscard]] bool flag(std::string_view key, bool fallback);
  /// Whole numbers within [low, high].
  [[nodiscard]] std::int64_t integer(std::string_view key, std::int64_t fallback, std::int64_t low, std::int64_t high);
  /// Those that the type has; of 64 bits without sign, those that TOML has.
  template <std::unsigned_integral T>
  [[nodiscard]] T get(std::string_view key, T fallback) {
    constexpr auto kHigh = sizeof(T) < 8 ? static_cast<std::int64_t>(std::numeric_limits<T>::max()) : INT64_MAX;
    return static_cast<T>(integer(key, static_cast<std::int64_t>(fallback), 0, kHigh));
  }
  /// Numbers within [low, high], with or without a fraction.
  [[nodiscard]] double number(std::string_view key, double fallback, double low, double high);
  /// From milliseconds; 0 to thirty days.
  [[nodiscard]] Nanoseconds time_ms(std::string_view key, double fallback);

  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
  /// Null where there is none.
  [[nodiscard]] const toml::table* table(std::string_view key);
  [[nodiscard]] const toml::array* tables(std::string_view key);
  [[nodiscard]] const toml::array* array(std::string_view key);

  /// At the key's line; at the table's where it is not there.
  template <class... Given>
  void fail_at(std::string_view key, std::type_identity_t<ReasonRow<sizeof...(Given)>> row, const Given&... given) {
    if (!error_) set_error(key, because(row, given...));
  }
  /// What reading a file that the key names ended with: at the key where the file is not there or cannot be read, or
  /// where the error has no place of its own; what is wrong in the file stays where it stands.
  void fail_with_file(std::string_view key, Error error);
  void reject_unknown_keys(ReasonRow<0> where = "a scenario");
  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] int line() const { return static_cast<int>(table_.source().begin.line); }

 private:
  [[nodiscard]] int line_of(std::string_view key) const;
  void set_error(std::string_view key, Reason detail);
  [[nodiscard]] const toml::node* ask(std::string_view key);

  const toml::table& table_;
  const std::string& file_;
  std::optional<Error>& error_;
  std::set<std::string, std::less<>> asked_;
};

/// The whole file. kTomlMalformed, and as read_whole_file().
[[nodiscard]] Result<toml::table> parse_toml(const std::string& path);
/// The same of a text that stands for the file.
[[nodiscard]] Result<toml::table> parse_toml_text(std::string_view text, const std::string& path);

}  // namespace syncline::sim
