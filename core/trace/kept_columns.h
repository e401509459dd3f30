// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "trace/min_max_series.h"

namespace syncline {

/// The columns of a series that is looked at again and again: a picture that follows the newest sample, or stands.
/// What was given last and cannot have changed since is not looked for again: of a window that slides by a column one
/// column is, however long the series. For one thread.
class KeptColumns {
 public:
  /// As MinMaxSeries::columns(), of this series now. Valid until the next call.
  const std::vector<SeriesColumn>& of(const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end,
                                      Nanoseconds width);
  /// As MinMaxSeries::step_columns(), which are looked for anew each time.
  const std::vector<SeriesColumn>& steps_of(const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end,
                                            Nanoseconds width, Nanoseconds hold_until);
  void clear() { columns_.clear(); }
  /// What of() gave last.
  [[nodiscard]] const std::vector<SeriesColumn>& columns() const { return columns_; }

 private:
  MinMaxSeries::Stand stand_;
  Nanoseconds width_ = 0;
  std::vector<SeriesColumn> columns_, found_;
};

}  // namespace syncline
