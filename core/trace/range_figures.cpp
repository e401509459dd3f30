// SPDX-License-Identifier: Apache-2.0
#include "trace/range_figures.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "trace/counted_cycle.h"
#include "trace/untold.h"

namespace syncline {

void RangeFigure::add(Nanoseconds time, const SignalNumber& number) {
  const double value = as_double(number);
  newest = {time, value};
  statistics.add(value);
  if (const auto* whole = std::get_if<std::int64_t>(&number)) magnitudes.add(std::abs(*whole));
  if (!largest || std::abs(value) > std::abs(largest->value)) largest = newest;
}

std::optional<std::int64_t> RangeFigure::quantile(double fraction) const {
  if (magnitudes.count() == 0) return std::nullopt;
  return magnitudes.percentile(fraction);
}

std::optional<double> RangeFigure::margin(double limit) const {
  if (limit <= 0 || !largest) return std::nullopt;
  return 1 - std::abs(largest->value) / limit;
}

RangeFigures::RangeFigures(std::size_t slaves, Nanoseconds begin, Nanoseconds end, bool armed)
    : begin_(begin), end_(end), armed_(armed), slaves_(slaves), counters_(slaves) {
  for (const auto& row : syncline::signals()) {
    const bool own = row.form == SignalInfo::Form::kCycles || row.form == SignalInfo::Form::kReadings;
    if (own && row.of_cycle != nullptr) signals_.emplace_back().signal = row.id;
  }
}

void RangeFigures::add(std::span<const CycleSample> samples) {
  for (const auto& sample : samples) add(sample);
}

void RangeFigures::add(const CycleSample& sample) {
  if (sample.send_time >= end_) return;
  add_missed(sample);
  if (sample.send_time < begin_) return;
  if (armed_ && !counts_in_figures(sample)) return;
  ++cycles_;
  untold_ |= sample.flags & (kFramesUntold | kExpectedUntold | kLatenessUntold);
  lost_frames_ += sample.frames_lost;
  skipped_cycles_ += sample.skipped_cycles;
  if ((sample.flags & CycleSample::kWkcError) != 0) ++wkc_errors_;
  for (auto& [signal, figure, lasting] : signals_) {
    const auto number = info(signal).of_cycle(sample);
    if (!number) continue;
    figure.add(sample.send_time, *number);
    if (signal == Signal::kDcmErrorFiltered) lasting.add(sample.send_time, std::abs(sample.dcm_error_filtered_ns));
  }
  const bool follows = sample.slave_position >= 0 && (sample.flags & CycleSample::kSlaveFollows) != 0;
  if (follows && static_cast<std::size_t>(sample.slave_position) < slaves_.size()) {
    slaves_[static_cast<std::size_t>(sample.slave_position)].deviation.add(
        sample.send_time, SignalNumber(std::int64_t{sample.slave_deviation_ns}));
  }
}

/// Counters are known from before the stretch, too: what they have grown by in it counts.
void RangeFigures::add_missed(const CycleSample& sample) {
  if (sample.sm2_position < 0 || static_cast<std::size_t>(sample.sm2_position) >= slaves_.size()) return;
  const auto slave = static_cast<std::size_t>(sample.sm2_position);
  const auto now = sample.slave_sm2_missed;
  const auto before = std::exchange(counters_[slave], now);
  if (sample.send_time < begin_ || !before) return;
  // A counter that went back was cleared: what it shows now came since.
  slaves_[slave].missed = slaves_[slave].missed.value_or(0) + (now >= *before ? now - *before : now);
}

}  // namespace syncline
