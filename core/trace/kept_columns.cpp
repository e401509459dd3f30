// SPDX-License-Identifier: Apache-2.0
#include "trace/kept_columns.h"

#include <algorithm>

namespace syncline {

const std::vector<SeriesColumn>& KeptColumns::steps_of(const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end,
                                                       Nanoseconds width, Nanoseconds hold_until) {
  stand_ = {};  // of no series: nothing of it is kept
  series.step_columns(begin, end, width, hold_until, columns_);
  return columns_;
}

const std::vector<SeriesColumn>& KeptColumns::of(const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end,
                                                 Nanoseconds width) {
  const auto stand = series.stand();
  const bool same = width_ == width && stand_.filling == stand.filling;
  const auto last_time = std::min(stand_.last_time, stand.last_time);  // of a recording later ones may be hidden again
  const bool none_went = stand_.gone == stand.gone;
  stand_ = stand;
  width_ = width;
  if (!same || columns_.empty() || width <= 0 || end <= begin) {
    series.columns(begin, end, width, columns_);
    return columns_;
  }
  // Another sample may still come at the time of the last one, and of those at the time of the first one some may be
  // gone.
  const auto changed_to = none_went ? begin : std::max(begin, series.first_time() + 1);
  const auto keeps = [&](const SeriesColumn& column) {
    return column.start + width > begin && column.start < end && column.start >= changed_to &&
           column.start + width <= last_time;
  };
  const auto first = std::find_if(columns_.begin(), columns_.end(), keeps);
  const auto last = std::find_if_not(first, columns_.end(), keeps);
  if (first == last) {
    series.columns(begin, end, width, columns_);
    return columns_;
  }
  columns_.erase(last, columns_.end());
  columns_.erase(columns_.begin(), first);
  const auto kept_from = columns_.front().start;
  const auto kept_to = columns_.back().start + width;
  if (kept_to < end) {
    series.columns(kept_to, end, width, found_);
    columns_.insert(columns_.end(), found_.begin(), found_.end());
  }
  if (begin < kept_from) {
    series.columns(begin, kept_from, width, found_);
    columns_.insert(columns_.begin(), found_.begin(), found_.end());
  }
  return columns_;
}

}  // namespace syncline
