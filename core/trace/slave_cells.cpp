// SPDX-License-Identifier: Apache-2.0
#include "trace/slave_cells.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "trace/sample_store.h"

namespace syncline {
namespace {

/// With more readings a column the pyramid is faster than every one of them.
constexpr std::size_t kReadingsOneByOne = 6;

using CellReading = MinMaxSeries::Reading;

/// Some columns of one slave.
class CellRow {
 public:
  CellRow(const MinMaxSeries& series, std::span<const Outage> outages, const SlaveCells::Grid& grid,
          Nanoseconds longest, Nanoseconds until)
      : series_(series), outages_(outages), grid_(grid), longest_(longest), until_(until) {}

  void fill(std::span<float> cells, std::size_t begin, std::size_t end, std::vector<SeriesColumn>& scratch) {
    cells_ = cells;
    begin_ = begin;
    end_ = end;
    std::fill(cells.begin() + static_cast<std::ptrdiff_t>(begin), cells.begin() + static_cast<std::ptrdiff_t>(end),
              SlaveCells::kNoReading);
    if (series_.empty()) return;
    if (series_.count(start(begin), start(end)) <= kReadingsOneByOne * (end - begin)) {
      take_readings();
    } else {
      take_columns(scratch);
    }
  }

 private:
  [[nodiscard]] Nanoseconds start(std::size_t column) const {
    return grid_.origin + static_cast<Nanoseconds>(column) * grid_.width;
  }
  /// Of a time at or behind the begin of the part.
  [[nodiscard]] std::size_t column_of(Nanoseconds time) const {
    return static_cast<std::size_t>((time - grid_.origin) / grid_.width);
  }

  /// Until when a reading holds, that time not included.
  [[nodiscard]] Nanoseconds hold_end(Nanoseconds time, const std::optional<CellReading>& next) const {
    const auto until = next ? next->time : until_ + 1;
    if (until - time > longest_ + (next ? 0 : 1)) return time;
    const auto outage = std::ranges::upper_bound(outages_, time, {}, &Outage::end);
    return outage == outages_.end() ? until : std::min(until, std::max(outage->begin, time));
  }

  /// The first reading at or behind `from` that comes early enough for one of `time` to hold until then.
  [[nodiscard]] std::optional<CellReading> next(Nanoseconds from, Nanoseconds time) const {
    std::optional<CellReading> first;
    series_.for_each(from, time + longest_ + 1, [&first](Nanoseconds at, float value) {
      if (!first && !std::isnan(value)) first = CellReading{at, value};
    });
    return first;
  }

  /// Cells [from, to) have no reading of their own; `before` is the one before them.
  void hold(const CellReading& before, const std::optional<CellReading>& next, std::size_t from, std::size_t to) {
    const auto until = hold_end(before.time, next);
    for (auto column = from; column < to && start(column) < until; ++column) cells_[column] = std::abs(before.value);
  }

  void take_readings() {
    auto before = series_.at(start(begin_) - 1);
    auto empty = begin_;  // first column that nothing has been decided of
    series_.for_each(start(begin_), start(end_), [&](Nanoseconds time, float value) {
      if (std::isnan(value)) return;
      // Most fall into the column of the one before.
      const auto column = empty > begin_ && time < start(empty) ? empty - 1 : column_of(time);
      const CellReading reading{time, value};
      if (before && column > empty) hold(*before, reading, empty, column);
      cells_[column] = std::max(cells_[column], std::abs(value));
      before = reading;
      empty = column + 1;
    });
    if (before && empty < end_) hold(*before, next(start(end_), before->time), empty, end_);
  }

  void take_columns(std::vector<SeriesColumn>& columns) {
    series_.columns(start(begin_), start(end_), grid_.width, columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto& column = columns[i];
      if (column.valid) {
        cells_[begin_ + i] = std::max(std::abs(column.min), std::abs(column.max));
        continue;
      }
      const auto from = i;
      while (i + 1 < columns.size() && !columns[i + 1].valid) ++i;
      const auto before = series_.at(columns[from].start - 1);
      if (!before) continue;
      hold(*before, next(columns[i].start + grid_.width, before->time), begin_ + from, begin_ + i + 1);
    }
  }

  const MinMaxSeries& series_;
  std::span<const Outage> outages_;
  const SlaveCells::Grid& grid_;
  Nanoseconds longest_, until_;
  std::span<float> cells_;
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace

void SlaveCells::forget() {
  cells_.clear();
  firsts_.clear();
  grid_ = {};
  carried_ = {};
  until_ = 0;
}

SlaveCells::Carried SlaveCells::kept(const Grid& grid, Nanoseconds longest) const {
  if (grid.width != grid_.width || grid_.columns == 0) return {};
  // What ends before is settled: the next reading is known, or comes too late.
  const auto settled = (until_ - longest - grid_.origin) / grid_.width;
  const auto shift = (grid.origin - grid_.origin) / grid_.width;
  const auto columns = static_cast<Nanoseconds>(grid.columns);
  const auto begin = std::max<Nanoseconds>(-shift, 0);
  const auto end = std::min({columns, settled - shift, static_cast<Nanoseconds>(grid_.columns) - shift});
  if (begin >= end) return {};
  return {static_cast<std::size_t>(begin), static_cast<std::size_t>(end), static_cast<std::ptrdiff_t>(shift)};
}

void SlaveCells::show(const SampleStore& store, const Grid& grid) {
  if (store.slave_count() != firsts_.size()) forget();
  const auto longest = store.longest_gap(Signal::kSlaveDeviation);
  const auto known = kept(grid, longest);
  const auto before = std::exchange(grid_, grid);
  until_ = store.empty() ? 0 : store.last_time();
  // What the store has forgotten is forgotten here, too: those rows are made anew.
  std::vector<Nanoseconds> firsts(store.slave_count());
  for (std::size_t slave = 0; slave < firsts.size(); ++slave)
    firsts[slave] = store.series(Signal::kSlaveDeviation, slave).first_time();
  firsts_.resize(firsts.size(), 0);
  const bool same_firsts = firsts == firsts_;
  const bool all = known.begin == known.end;
  carried_ = same_firsts ? known : Carried{};
  const auto fresh = all || known.begin > 0 || !same_firsts ? 0 : known.end;
  const auto origin = grid.origin + static_cast<Nanoseconds>(fresh) * grid.width;
  outages_ = outages(store, origin - longest,
                     grid.origin + static_cast<Nanoseconds>(grid.columns) * grid.width + longest, grid.width);
  cells_.swap(old_);
  cells_.resize(firsts_.size() * grid.columns);
  for (std::size_t slave = 0; slave < firsts_.size(); ++slave) {
    if (firsts[slave] != std::exchange(firsts_[slave], firsts[slave]) || all) {
      fill(store, slave, 0, grid.columns);
      continue;
    }
    const auto source = old_.begin() + static_cast<std::ptrdiff_t>(slave * before.columns) +
                        static_cast<std::ptrdiff_t>(known.begin) + known.moved;
    std::copy_n(source, known.end - known.begin,
                cells_.begin() + static_cast<std::ptrdiff_t>(slave * grid.columns + known.begin));
    fill(store, slave, 0, known.begin);
    fill(store, slave, known.end, grid.columns);
  }
}

void SlaveCells::fill(const SampleStore& store, std::size_t slave, std::size_t begin, std::size_t end) {
  if (begin == end) return;
  CellRow row(store.series(Signal::kSlaveDeviation, slave), outages_, grid_, store.longest_gap(Signal::kSlaveDeviation),
              until_);
  row.fill(std::span(cells_).subspan(slave * grid_.columns, grid_.columns), begin, end, columns_);
}

}  // namespace syncline
