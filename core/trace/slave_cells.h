// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "support/types.h"
#include "trace/min_max_series.h"
#include "trace/outages.h"

namespace syncline {

class SampleStore;

/// Deviations of all slaves over time as cells, slaves x columns, for a heat map. Slaves are read in turn, so this rule
/// says what a cell shows:
///  - Readings lie in it: the largest magnitude of these, so that a single one is seen at every zoom.
///  - It lies between two readings of its slave that are no further apart than SampleStore::longest_gap(): the older
///    one holds. So does the newest one while it is no older than that.
///  - Else, that is while the slave was absent, during an outage of the run and from there to the next reading, before
///    the run and behind it: kNoReading.
/// Of a reference clock the store holds no deviation: its row has no reading.
/// What cannot change any more is kept from one call to the next. Lives in the thread of the store.
class SlaveCells {
 public:
  static constexpr float kNoReading = -1;
  struct Grid {
    Nanoseconds origin = 0;  // a multiple of the width
    Nanoseconds width = 1;   // of a column, ns, at least 1
    std::size_t columns = 0;
    bool operator==(const Grid&) const = default;
  };

  /// Makes the cells of the grid. Another store than last time: forget() first.
  void show(const SampleStore& store, const Grid& grid);
  void forget();
  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// What the last show() has from the one before it: columns [begin, end) of each row, which stood `moved` columns
  /// further right then.
  struct Carried {
    std::size_t begin = 0, end = 0;
    std::ptrdiff_t moved = 0;
  };
  [[nodiscard]] const Carried& carried() const { return carried_; }
  [[nodiscard]] std::size_t slaves() const { return firsts_.size(); }
  /// Magnitudes in ns, or kNoReading; by column.
  [[nodiscard]] std::span<const float> row(std::size_t slave) const {
    return std::span(cells_).subspan(slave * grid_.columns, grid_.columns);
  }

 private:
  /// Of the new grid.
  [[nodiscard]] Carried kept(const Grid& grid, Nanoseconds longest) const;
  void fill(const SampleStore& store, std::size_t slave, std::size_t begin, std::size_t end);

  Grid grid_;
  Carried carried_;
  Nanoseconds until_ = 0;            // the newest cycle
  std::vector<float> cells_, old_;   // row by row
  std::vector<Nanoseconds> firsts_;  // of each series, when its row was made
  std::vector<Outage> outages_;
  std::vector<SeriesColumn> columns_;
};

}  // namespace syncline
