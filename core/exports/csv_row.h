// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace syncline::exports {

/// Puts a row of CSV together.
class CsvRow {
 public:
  CsvRow& text(std::string_view value);
  template <std::integral T>
  CsvRow& number(T value) {
    return raw(std::to_string(value));
  }
  CsvRow& hex(std::uint32_t value, int digits);
  CsvRow& empty() { return raw({}); }
  /// The row with its end.
  [[nodiscard]] std::string end() const { return row_ + "\r\n"; }

 private:
  CsvRow& raw(std::string_view value);

  std::string row_;
  bool first_ = true;
};

}  // namespace syncline::exports
