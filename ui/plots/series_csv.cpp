// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/series_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "support/csv_field.h"
#include "trace/min_max_series.h"

namespace syncline::ui {
namespace {

struct Sample {
  Nanoseconds time;
  float value;
};

}  // namespace

std::string iso_utc(Nanoseconds time) {
  namespace chrono = std::chrono;
  auto seconds = time / kSecond;
  auto rest = time % kSecond;
  if (rest < 0) {
    rest += kSecond;
    --seconds;
  }
  const chrono::sys_seconds at{chrono::seconds(seconds + kDcEpochUnixSeconds)};
  const auto day = chrono::floor<chrono::days>(at);
  const chrono::year_month_day date{day};
  const chrono::hh_mm_ss clock{at - day};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:09}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), clock.hours().count(),
                     clock.minutes().count(), clock.seconds().count(), rest);
}

CsvTable::CsvTable(std::vector<CsvColumn> columns, CycleAt cycle_at, Nanoseconds origin, Nanoseconds begin,
                   Nanoseconds end)
    : columns_(std::move(columns)), cycle_at_(std::move(cycle_at)), origin_(origin), begin_(begin), end_(begin) {
  // Nothing lies before the first sample of all, nor behind the last one.
  auto first = end, last = begin;
  for (const auto& column : columns_) {
    if (column.series->empty()) continue;
    first = std::min(first, column.series->first_time());
    last = std::max(last, column.series->last_time() + 1);
  }
  begin_ = next_ = std::max(begin, first);
  end_ = std::min(end, last);
}

std::string CsvTable::head() const {
  std::string out = "time_ns,time_utc,cycle";
  for (const auto& column : columns_) out += ',' + csv_field(column.name);
  return out + '\n';
}

CsvRows CsvTable::next(std::size_t values) {
  CsvRows rows;
  rows.origin = origin_;
  if (complete()) return rows;
  std::size_t left = 0;
  for (const auto& column : columns_) left += column.series->count(next_, end_);
  const double part = left <= values ? 1 : static_cast<double>(values) / static_cast<double>(left);
  const auto until =
      part == 1 ? end_
                : next_ + std::max<Nanoseconds>(static_cast<Nanoseconds>(part * static_cast<double>(end_ - next_)), 1);
  std::vector<std::vector<Sample>> samples(columns_.size());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    columns_[i].series->for_each(next_, until, [&](Nanoseconds time, float value) {
      samples[i].push_back({time, value});
    });
  }
  next_ = until;
  std::vector<std::size_t> at(columns_.size(), 0);
  for (;;) {
    std::optional<Nanoseconds> time;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (at[i] < samples[i].size() && (!time || samples[i][at[i]].time < *time)) time = samples[i][at[i]].time;
    }
    if (!time) return rows;
    rows.times.push_back(*time);
    rows.cycles.push_back(cycle_at_ ? cycle_at_(*time) : std::nullopt);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const bool there = at[i] < samples[i].size() && samples[i][at[i]].time == *time;
      rows.values.push_back(there ? samples[i][at[i]++].value : std::numeric_limits<float>::quiet_NaN());
    }
  }
}

int CsvTable::progress() const {
  if (complete() || end_ <= begin_) return 1000;
  return static_cast<int>(1000 * static_cast<double>(next_ - begin_) / static_cast<double>(end_ - begin_));
}

void append_csv(std::string& out, const CsvRows& rows) {
  const auto columns = rows.times.empty() ? 0 : rows.values.size() / rows.times.size();
  for (std::size_t row = 0; row < rows.times.size(); ++row) {
    fmt::format_to(std::back_inserter(out), "{},{},", rows.times[row] - rows.origin, iso_utc(rows.times[row]));
    if (rows.cycles[row]) fmt::format_to(std::back_inserter(out), "{}", *rows.cycles[row]);
    for (std::size_t i = 0; i < columns; ++i) {
      out += ',';
      const float value = rows.values[row * columns + i];
      if (!std::isnan(value)) fmt::format_to(std::back_inserter(out), "{}", value);
    }
    out += '\n';
  }
}

std::string series_csv(CsvTable table) {
  auto out = table.head();
  while (!table.complete()) append_csv(out, table.next(1U << 16));
  return out;
}

}  // namespace syncline::ui
