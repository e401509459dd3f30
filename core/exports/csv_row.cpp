// SPDX-License-Identifier: Apache-2.0
#include "exports/csv_row.h"

#include <fmt/format.h>

namespace syncline::exports {

CsvRow& CsvRow::text(std::string_view value) {
  if (value.find_first_of(",\"\r\n") == std::string_view::npos) return raw(value);
  std::string quoted = "\"";
  for (const char c : value) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return raw(quoted + "\"");
}

CsvRow& CsvRow::hex(std::uint32_t value, int digits) { return raw(fmt::format("0x{:0{}X}", value, digits)); }

CsvRow& CsvRow::raw(std::string_view value) {
  if (!first_) row_ += ',';
  first_ = false;
  row_ += value;
  return *this;
}

}  // namespace syncline::exports
