// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

struct CycleSample;

/// One line of the DCM log: a controller execution, in the units and with the signs of the EC-Master manual (2.1.4).
/// Its controller error is positive when the reference clock must run faster, its drift when the host's clock is the
/// faster one: both have the opposite sign of CycleSample's.
struct DcmLogRow {
  double time_ms = 0;                // since the first row
  std::int64_t set_value_ns = 0;     // distance between frame send time and SYNC0
  std::int64_t bus_time_ns = 0;      // system time
  std::int64_t bus_time_off_ns = 0;  // system time modulo sync cycle time
  std::int64_t adjust_ns = 0;
  std::int64_t error_ns = 0;
  std::int64_t error_filtered_ns = 0;
  double drift_ppm = 0;           // between local clock and reference clock
  double error_tenth_permil = 0;  // error in 1/10 per mille of the cycle
  double output_sum = 0;          // integral part of the output, ns a cycle
  std::int64_t output_total = 0;  // all outputs since the start, ns
  std::int64_t dc_start_time_ns = 0;
  std::uint32_t error_code = 0;
  bool dcm_in_sync = false;
  bool dc_in_sync = false;
  std::optional<std::int64_t> system_time_difference_ns;  // while it is monitored
  bool operator==(const DcmLogRow&) const = default;
};

/// Makes rows of the samples as they come: the live stream. Cycles without a reading of the reference clock give none.
class DcmLog {
 public:
  DcmLog(Nanoseconds set_value, Nanoseconds cycle_time) : set_value_(set_value), cycle_(cycle_time) {}
  void set_start_time(Nanoseconds dc_start_time) { start_time_ = dc_start_time; }
  [[nodiscard]] std::optional<DcmLogRow> row(const CycleSample& sample);

 private:
  Nanoseconds set_value_, cycle_;
  Nanoseconds start_time_ = 0;
  std::optional<Nanoseconds> first_;
};

/// Header line with the manual's column names; columns are separated by semicolons.
[[nodiscard]] std::string dcm_log_header();
void append_dcm_log(std::string& out, const DcmLogRow& row);

/// Reads such a log, EC-Master's own too: columns by name and in any order, unknown ones skipped, missing ones left at
/// their defaults, separated by semicolon, comma or tabulator. kMalformedData with the line when a cell is no number, a
/// line has fewer cells than the header (SystemTimeDifference may be missing), or a log has no column that is known.
[[nodiscard]] Result<std::vector<DcmLogRow>> read_dcm_log(std::string_view text);
/// The same with what it has.
struct DcmLogTable {
  std::vector<DcmLogRow> rows;
  std::vector<std::string> columns;  // those that are known, named as in dcm_log_header()
  /// The last line where it has no end, 0: it has one. Left out where cells are missing or are no numbers.
  int unended_line = 0;
  bool left_out = false;
  [[nodiscard]] bool has(std::string_view column) const;
};
[[nodiscard]] Result<DcmLogTable> read_dcm_table(std::string_view text);

}  // namespace syncline
