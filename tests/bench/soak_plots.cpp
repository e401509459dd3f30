// SPDX-License-Identifier: Apache-2.0
#include "bench/soak_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace syncline::bench {
namespace {

constexpr float kOp = 8;

bool is_beyond(const MinMaxSeries& series, Nanoseconds from, double limit) {
  const auto extent = series.extent(from, INT64_MAX);
  return limit > 0 && extent &&
         std::max(std::abs(static_cast<double>(extent->min)), std::abs(static_cast<double>(extent->max))) > limit;
}

bool rises(const MinMaxSeries& series, Nanoseconds from) {
  const auto before = series.held_at(from);
  const auto extent = series.extent(from, INT64_MAX);
  return extent && extent->max > (before ? before->value : 0);
}

bool leaves_op(const MinMaxSeries& series, Nanoseconds from) {
  bool left = false;
  series.for_each(from, INT64_MAX, [&left](Nanoseconds, float state) { left = left || !(state == kOp); });
  const auto before = series.held_at(from);
  return left || !before || before->value != kOp;
}

bool is_out_of_order(const SampleStore& store, const SignalInfo& row, std::size_t slave, const RunLimits& limits,
                     Nanoseconds from) {
  using Scope = SignalInfo::Scope;
  // Of the master's error what has lasted counts, which the filtered one is.
  const bool held_against =
      row.id == Signal::kDeviation || row.id == Signal::kSlaveDeviation || row.id == Signal::kDcmErrorFiltered;
  const auto& series = row.scope == Scope::kSlave ? store.series(row.id, slave) : store.series(row.id);
  if (held_against) return is_beyond(series, from, limit_of(limits, row.id));
  if (row.id == Signal::kAlState) return leaves_op(series, from);
  return row.form == SignalInfo::Form::kHeld && !row.since.empty() && rises(series, from);
}

}  // namespace

std::vector<ShownSignal> shown_out_of_order(const SampleStore& store, const RunLimits& limits, Nanoseconds from) {
  std::vector<ShownSignal> shown;
  for (const auto& row : signals()) {
    using Scope = SignalInfo::Scope;
    if (row.scope == Scope::kVariable || row.form == SignalInfo::Form::kCell) continue;
    if (row.form == SignalInfo::Form::kDerived) continue;
    const auto count = row.scope == Scope::kSlave ? store.slave_count() : 1;
    for (std::size_t slave = 0; slave < count; ++slave) {
      if (!is_out_of_order(store, row, slave, limits, from)) continue;
      shown.push_back({row.id, row.scope == Scope::kSlave ? static_cast<int>(slave) : -1});
    }
  }
  return shown;
}

bool has_gap(const SampleStore& store, Signal signal, std::size_t slave, Nanoseconds from, Nanoseconds until) {
  const auto& series = store.series(signal, slave);
  if (series.empty()) return false;
  // It ends with the last reading, which may have been in front of that.
  if (!series.held_at(from)) return !series.held_at(until);
  bool gap = store.heard(signal, slave) + HeldSeries::kPatience < store.last_time();
  series.for_each(from, INT64_MAX, [&gap](Nanoseconds, float value) { gap = gap || std::isnan(value); });
  return gap;
}

std::string text_of(const ShownSignal& shown) {
  const auto key = info(shown.signal).key;
  return shown.slave < 0 ? std::string(key) : fmt::format("{} of slave {}", key, shown.slave);
}

}  // namespace syncline::bench
