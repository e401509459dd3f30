// SPDX-License-Identifier: Apache-2.0
#include "trace/dcm_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "channels/cycle_sample.h"
#include "reasons/because.h"
#include "support/utf8.h"

namespace syncline {
namespace {

struct Column {
  std::string_view name;
  std::string (*format)(const DcmLogRow&);
  void (*parse)(DcmLogRow&, double);
};

/// Numbers of any size without undefined conversions.
std::int64_t integer(double value) {
  constexpr double kLargest = 9.2e18;
  return static_cast<std::int64_t>(std::llround(std::clamp(value, -kLargest, kLargest)));
}

template <auto Field>
Column whole(std::string_view name) {
  return {name, [](const DcmLogRow& r) { return fmt::format("{}", r.*Field); },
          [](DcmLogRow& r, double v) { r.*Field = integer(v); }};
}
template <auto Field, int Digits>
Column real(std::string_view name) {
  return {name, [](const DcmLogRow& r) { return fmt::format("{:.{}f}", r.*Field, Digits); },
          [](DcmLogRow& r, double v) { r.*Field = v; }};
}
template <auto Field>
Column flag(std::string_view name) {
  return {name, [](const DcmLogRow& r) { return std::string(r.*Field ? "1" : "0"); },
          [](DcmLogRow& r, double v) { r.*Field = v != 0; }};
}

const std::array<Column, 16>& columns() {
  static const std::array<Column, 16> kColumns{
      real<&DcmLogRow::time_ms, 3>("Time[ms]"),
      whole<&DcmLogRow::set_value_ns>("SyncSetVal [ns]"),
      whole<&DcmLogRow::bus_time_ns>("BusTime [ns]"),
      whole<&DcmLogRow::bus_time_off_ns>("BusTimeOff"),
      whole<&DcmLogRow::adjust_ns>("CtlAdj [ns]"),
      whole<&DcmLogRow::error_ns>("CtlErr [ns]"),
      whole<&DcmLogRow::error_filtered_ns>("CtlErrFilt"),
      real<&DcmLogRow::drift_ppm, 3>("Drift [ppm]"),
      real<&DcmLogRow::error_tenth_permil, 3>("CtlErr [1/10 pmil]"),
      real<&DcmLogRow::output_sum, 3>("CtlOutSum"),
      whole<&DcmLogRow::output_total>("CtlOutTot"),
      whole<&DcmLogRow::dc_start_time_ns>("DCStartTime"),
      Column{"DCMErrorCode", [](const DcmLogRow& r) { return fmt::format("0x{:08x}", r.error_code); },
             [](DcmLogRow& r, double v) { r.error_code = static_cast<std::uint32_t>(integer(v)); }},
      flag<&DcmLogRow::dcm_in_sync>("DCMInSync"),
      flag<&DcmLogRow::dc_in_sync>("DCInSync"),
      Column{"SystemTimeDifference [ns]",
             [](const DcmLogRow& r) {
               return r.system_time_difference_ns ? fmt::format("{}", *r.system_time_difference_ns) : std::string();
             },
             [](DcmLogRow& r, double v) { r.system_time_difference_ns = integer(v); }},
  };
  return kColumns;
}

/// Letters and digits only, small: "CtlErr [ns]" and "ctlerr[ns]" are the same column.
std::string plain(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') result += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) result += c;
  }
  return result;
}

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\r' || c == '"'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> cells(std::string_view line, char separator) {
  std::vector<std::string_view> result;
  for (;;) {
    const auto end = line.find(separator);
    result.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return result;
    line.remove_prefix(end + 1);
  }
}

bool parse_whole(std::string_view text, int base, double& value, std::int64_t& exact) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exact, base);
  value = static_cast<double>(exact);
  return error == std::errc() && end == text.data() + text.size();
}

struct Cell {
  double value = 0;
  std::optional<std::int64_t> exact;  // times in ns do not fit a double
};

std::optional<Cell> parse_cell(std::string_view text) {
  Cell cell;
  std::int64_t exact = 0;
  const bool hex = text.starts_with("0x") || text.starts_with("0X");
  if (parse_whole(hex ? text.substr(2) : text, hex ? 16 : 10, cell.value, exact)) {
    cell.exact = exact;
    return cell;
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), cell.value);
  if (hex || error != std::errc() || end != text.data() + text.size() || !std::isfinite(cell.value))
    return std::nullopt;
  return cell;
}

void store(DcmLogRow& row, std::size_t column, const Cell& cell) {
  constexpr std::size_t kBusTime = 2, kStartTime = 11;
  columns()[column].parse(row, cell.value);
  if (cell.exact && column == kBusTime) row.bus_time_ns = *cell.exact;
  if (cell.exact && column == kStartTime) row.dc_start_time_ns = *cell.exact;
}

struct Header {
  char separator = ';';
  std::vector<std::optional<std::size_t>> columns;  // of each cell
};

std::optional<Header> read_header(std::string_view line) {
  Header header;
  for (const char separator : {'\t', ';', ','}) {
    if (line.find(separator) == std::string_view::npos) continue;
    header.separator = separator;
    break;
  }
  bool any = false;
  for (const auto name : cells(line, header.separator)) {
    const auto found = std::ranges::find_if(columns(), [&](const Column& c) { return plain(c.name) == plain(name); });
    if (found == columns().end()) {
      header.columns.emplace_back();
    } else {
      header.columns.emplace_back(static_cast<std::size_t>(found - columns().begin()));
      any = true;
    }
  }
  return any ? std::optional(header) : std::nullopt;
}

/// How many cells a line has at least. What is not monitored some programs leave out at its end.
std::size_t needed_cells(const Header& header) {
  std::size_t needed = 0;
  for (std::size_t i = 0; i < header.columns.size(); ++i) {
    if (header.columns[i] && *header.columns[i] + 1 < columns().size()) needed = i + 1;
  }
  return needed;
}

/// Why the line is none; empty: it is.
Reason read_row(const Header& header, std::string_view line, DcmLogRow& row) {
  const auto values = cells(line, header.separator);
  if (const auto needed = needed_cells(header); values.size() < needed)
    return because("of {other} cells it has only {count}", needed, values.size());
  for (std::size_t i = 0; i < values.size() && i < header.columns.size(); ++i) {
    if (!header.columns[i] || values[i].empty()) continue;
    const auto cell = parse_cell(values[i]);
    if (!cell) return because("\"{text}\" is no number", values[i].substr(0, 40));
    store(row, *header.columns[i], *cell);
  }
  return {};
}

}  // namespace

std::optional<DcmLogRow> DcmLog::row(const CycleSample& sample) {
  if ((sample.flags & CycleSample::kReferenceValid) == 0) return std::nullopt;
  if (!first_) first_ = sample.send_time;
  DcmLogRow row;
  row.time_ms = static_cast<double>(sample.send_time - *first_) / static_cast<double>(kMillisecond);
  row.set_value_ns = set_value_;
  row.bus_time_ns = sample.reference_time;
  row.bus_time_off_ns = cycle_ > 0 ? ((sample.reference_time % cycle_) + cycle_) % cycle_ : 0;
  row.adjust_ns = sample.dcm_adjust_ns;
  row.error_ns = -std::int64_t{sample.dcm_error_ns};
  row.error_filtered_ns = -std::int64_t{sample.dcm_error_filtered_ns};
  row.drift_ppm = -static_cast<double>(sample.drift_ppm);
  row.error_tenth_permil = cycle_ > 0 ? static_cast<double>(row.error_ns) * 1e4 / static_cast<double>(cycle_) : 0;
  row.output_sum = sample.dcm_output_sum_ns;
  row.output_total = sample.dcm_output_total_ns;
  row.dc_start_time_ns = start_time_;
  row.error_code = sample.dcm_error_code;
  row.dcm_in_sync = sample.master_sync == SyncState::kInSync;
  row.dc_in_sync = sample.slaves_sync == SyncState::kInSync;
  if ((sample.flags & CycleSample::kDeviationValid) != 0) row.system_time_difference_ns = sample.deviation_ored_ns;
  return row;
}

std::string dcm_log_header() {
  std::string text;
  for (const auto& column : columns()) text += (text.empty() ? "" : ";") + std::string(column.name);
  return text + '\n';
}

void append_dcm_log(std::string& out, const DcmLogRow& row) {
  bool first = true;
  for (const auto& column : columns()) {
    if (!first) out += ';';
    first = false;
    out += column.format(row);
  }
  out += '\n';
}

bool DcmLogTable::has(std::string_view column) const { return std::ranges::find(columns, column) != columns.end(); }

Result<std::vector<DcmLogRow>> read_dcm_log(std::string_view text) {
  auto table = read_dcm_table(text);
  if (!table) return tl::unexpected(table.error());
  return std::move(table->rows);
}

Result<DcmLogTable> read_dcm_table(std::string_view text) {
  std::optional<Header> header;
  DcmLogTable table;
  int number = 0;
  text = without_mark(text);
  const auto bad = [&number](Reason detail) {
    return fail(Error{.code = ErrorCode::kMalformedData,
                      .subject = fmt::format("line {} of the DCM log", number),
                      .detail = std::move(detail),
                      .line = number});
  };
  while (!text.empty()) {
    ++number;
    const auto end = text.find('\n');
    const auto line = trimmed(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.empty()) continue;
    if (!header) {
      header = read_header(line);
      if (!header) return bad(because("it names none of the log's columns"));
      for (const auto& column : header->columns) {
        if (column) table.columns.emplace_back(columns()[*column].name);
      }
      continue;
    }
    DcmLogRow row;
    const auto wrong = read_row(*header, line, row);
    if (end == std::string_view::npos) {
      table.unended_line = number;
      table.left_out = !wrong.empty();
    } else if (!wrong.empty()) {
      return bad(wrong);
    }
    if (wrong.empty()) table.rows.push_back(row);
  }
  if (!header) return bad(because("it is empty"));
  return table;
}

}  // namespace syncline
