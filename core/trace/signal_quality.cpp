// SPDX-License-Identifier: Apache-2.0
#include "trace/signal_quality.h"

#include <algorithm>
#include <cmath>

#include "trace/untold.h"

namespace syncline {
namespace {

using Form = SignalInfo::Form;

/// Of the stretch before `time`, or of what there is of it.
std::optional<double> rate_of(const MinMaxSeries& series, const SampleStore& store, Nanoseconds time) {
  const auto from = std::max(time - kQualitySpan, store.first_time());
  const auto until = std::min(time, store.last_time());
  if (until <= from) return std::nullopt;
  std::size_t readings = 0;
  series.for_each(from, until, [&readings](Nanoseconds, float value) { readings += std::isnan(value) ? 0 : 1; });
  return static_cast<double>(readings) * 1e9 / static_cast<double>(until - from);
}

void look_at_held(const HeldSeries& held, Nanoseconds time, SignalQuality& quality) {
  if (!held.at(std::min(time, held.heard()))) return;
  quality.age = std::max<Nanoseconds>(time - held.heard(), 0);
  const auto interval = held.interval();
  if (interval) quality.rate = 1e9 / static_cast<double>(*interval);
}

}  // namespace

std::optional<Nanoseconds> value_doubt(const SignalInfo& signal, std::optional<Nanoseconds> stamps) {
  if (signal.unit != "ns") return std::nullopt;
  switch (signal.clock) {
    case SignalInfo::Clock::kSlaves:
      return kSlaveClockStep;
    case SignalInfo::Clock::kHost:
      return stamps;
    case SignalInfo::Clock::kBoth:
      return stamps ? std::optional(*stamps + kSlaveClockStep) : std::nullopt;
    case SignalInfo::Clock::kNone:
      break;
  }
  return std::nullopt;
}

SignalQuality quality_of(const SampleStore& store, Signal signal, std::size_t slave, Nanoseconds time) {
  const auto& row = info(signal);
  SignalQuality quality;
  quality.clock = row.clock;
  if (row.form == Form::kCell || store.empty()) return quality;
  quality.stamped_by = store.stamped_by();
  const auto doubts = store.series(Signal::kStampDoubt).extent(time - kQualitySpan, time + 1);
  if (doubts) quality.time_doubt = std::llround(static_cast<double>(doubts->max));
  // The doubt is what it is told by: nothing says how sure it is.
  if (signal != Signal::kStampDoubt) quality.value_doubt = value_doubt(row, quality.time_doubt);
  if (const auto* held = store.held(signal, slave)) {
    look_at_held(*held, time, quality);
    if (const auto interval = held->interval())
      quality.time_doubt = quality.time_doubt ? std::max(*quality.time_doubt, *interval) : *interval;
    return quality;
  }
  // An arrival phase is made of each frame that came back.
  const auto& series = row.form == Form::kDerived ? store.series(answered_signal(store)) : store.series(signal, slave);
  quality.rate = rate_of(series, store, time);
  if (const auto reading = series.at(time)) quality.age = time - reading->time;
  return quality;
}

std::string_view name_of(StampSource source) {
  switch (source) {
    case StampSource::kUntold:
      break;
    case StampSource::kSoftware:
      return "software";
    case StampSource::kKernel:
      return "kernel";
    case StampSource::kAdapter:
      return "adapter";
    case StampSource::kCapture:
      return "capture";
    case StampSource::kProbe:
      return "probe";
  }
  return "untold";
}

std::string_view name_of(SignalInfo::Clock clock) {
  switch (clock) {
    case SignalInfo::Clock::kNone:
      break;
    case SignalInfo::Clock::kHost:
      return "host";
    case SignalInfo::Clock::kSlaves:
      return "slaves";
    case SignalInfo::Clock::kBoth:
      return "both";
  }
  return "none";
}

}  // namespace syncline
