// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/series_csv.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "support/csv_field.h"

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

std::string series_csv(const std::vector<CsvColumn>& columns, const CycleAt& cycle_at, Nanoseconds origin,
                       Nanoseconds begin, Nanoseconds end) {
  std::string out = "time_ns,time_utc,cycle";
  std::vector<std::vector<Sample>> samples(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    out += ',' + csv_field(columns[i].name);
    samples[i].reserve(columns[i].series->count(begin, end));
    columns[i].series->for_each(begin, end, [&](Nanoseconds time, float value) {
      samples[i].push_back({time, value});
    });
  }
  out += '\n';
  std::vector<std::size_t> next(columns.size(), 0);
  for (;;) {
    std::optional<Nanoseconds> time;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (next[i] < samples[i].size() && (!time || samples[i][next[i]].time < *time)) time = samples[i][next[i]].time;
    }
    if (!time) return out;
    fmt::format_to(std::back_inserter(out), "{},{},", *time - origin, iso_utc(*time));
    if (const auto cycle = cycle_at ? cycle_at(*time) : std::nullopt)
      fmt::format_to(std::back_inserter(out), "{}", *cycle);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      out += ',';
      if (next[i] >= samples[i].size() || samples[i][next[i]].time != *time) continue;
      const float value = samples[i][next[i]++].value;
      if (!std::isnan(value)) fmt::format_to(std::back_inserter(out), "{}", value);
    }
    out += '\n';
  }
}

}  // namespace syncline::ui
