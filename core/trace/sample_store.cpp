// SPDX-License-Identifier: Apache-2.0
#include "trace/sample_store.h"

#include <algorithm>
#include <limits>

namespace syncline {
namespace {

constexpr Nanoseconds kRepeatEvery = 100 * kMillisecond;
constexpr float kGap = std::numeric_limits<float>::quiet_NaN();

float valid_or_gap(const CycleSample& sample, unsigned flag, float value) {
  const bool lost = (sample.flags & CycleSample::kFrameLost) != 0;
  return !lost && (sample.flags & flag) != 0 ? value : kGap;
}

}  // namespace

SampleStore::SampleStore(std::size_t slaves, std::size_t cycle_capacity) {
  for (std::size_t i = 0; i < kSeriesCount; ++i) series_.emplace_back(cycle_capacity);
  const auto per_slave = std::max<std::size_t>(slaves == 0 ? 0 : cycle_capacity / slaves, 8192);
  for (std::size_t i = 0; i < slaves; ++i) {
    deviation_.emplace_back(per_slave);
    sm2_missed_.emplace_back(8192);
  }
}

void SampleStore::clear() {
  for (auto& series : series_) series.clear();
  for (auto& series : deviation_) series.clear();
  for (auto& series : sm2_missed_) series.clear();
  any_ = false;
  missing_cycles_ = 0;
}

void SampleStore::append(std::span<const CycleSample> samples) {
  for (const auto& sample : samples) append(sample);
}

void SampleStore::append(const CycleSample& sample) {
  if (any_ && sample.cycle > next_cycle_) {
    missing_cycles_ += sample.cycle - next_cycle_;
    // One gap sample just before keeps the line from being joined across what is missing.
    for (auto& series : series_) series.append(sample.send_time - 1, kGap);
  }
  any_ = true;
  next_cycle_ = sample.cycle + 1;

  const auto time = sample.send_time;
  using Flag = CycleSample::Flag;
  at(Series::kDeviation)
      .append(time, valid_or_gap(sample, Flag::kFollowersRead, static_cast<float>(sample.deviation_ns)));
  const bool dcm = (sample.flags & Flag::kDcmActive) != 0;
  at(Series::kDcmError)
      .append(time, valid_or_gap(sample, Flag::kReferenceValid, dcm ? static_cast<float>(sample.dcm_error_ns) : kGap));
  at(Series::kDcmErrorFiltered).append(time, dcm ? static_cast<float>(sample.dcm_error_filtered_ns) : kGap);
  at(Series::kDrift).append(time, dcm ? sample.drift_ppm : kGap);
  at(Series::kLateness).append(time, static_cast<float>(sample.wake_lateness_ns));
  at(Series::kRoundTrip)
      .append(time, (sample.flags & Flag::kFrameLost) != 0 ? kGap : static_cast<float>(sample.round_trip_ns));

  // What a reference clock shows there is no deviation from itself.
  const bool follows = sample.slave_position >= 0 && (sample.flags & Flag::kSlaveFollows) != 0;
  if (follows && static_cast<std::size_t>(sample.slave_position) < deviation_.size()) {
    deviation_[static_cast<std::size_t>(sample.slave_position)].append(time,
                                                                       static_cast<float>(sample.slave_deviation_ns));
  }
  if (sample.sm2_position >= 0 && static_cast<std::size_t>(sample.sm2_position) < sm2_missed_.size()) {
    auto& series = sm2_missed_[static_cast<std::size_t>(sample.sm2_position)];
    const auto value = static_cast<float>(sample.slave_sm2_missed);
    const auto last = series.at(time);
    if (!last || last->value != value || time - last->time >= kRepeatEvery) series.append(time, value);
  }
}

}  // namespace syncline
