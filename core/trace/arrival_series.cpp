// SPDX-License-Identifier: Apache-2.0
#include "trace/arrival_series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "channels/cycle_sample.h"
#include "dc/sync0_arrival.h"

namespace syncline {
namespace {

constexpr float kNoArrival = std::numeric_limits<float>::quiet_NaN();

bool is_known(const CycleSample& sample) {
  constexpr auto kBoth = CycleSample::kReferenceValid | CycleSample::kSyncBaseValid;
  return (sample.flags & (kBoth | CycleSample::kFrameLost)) == kBoth;
}

/// Steps of a held value, one behind the other.
class Steps {
 public:
  Steps(const MinMaxSeries& held, Nanoseconds from) {
    if (const auto holds = held.held_at(from)) value_ = holds->value;
    held.for_each(from + 1, INT64_MAX, [this](Nanoseconds time, float value) { next_.emplace_back(time, value); });
  }
  /// Of times that do not go back.
  float at(Nanoseconds time) {
    for (; done_ < next_.size() && next_[done_].first <= time; ++done_) value_ = next_[done_].second;
    return value_;
  }

 private:
  float value_ = kNoArrival;
  std::vector<std::pair<Nanoseconds, float>> next_;
  std::size_t done_ = 0;
};

}  // namespace

ArrivalSeries::ArrivalSeries(const MinMaxSeries& axis, std::vector<Sync0Slave> slaves, Nanoseconds cycle_time,
                             Nanoseconds grid)
    : slaves_(std::move(slaves)),
      cycle_time_(cycle_time),
      turns_(grid > cycle_time && cycle_time > 0 ? grid / cycle_time : 1),
      capacity_(axis.capacity()) {
  if (std::ranges::none_of(slaves_, [](const Sync0Slave& slave) { return slave.period > 0; })) return;
  turn_.push_back(MinMaxSeries::beside(axis));
  in_cycle_.push_back(MinMaxSeries::beside(axis));
}

void ArrivalSeries::append(std::span<const CycleSample> samples, std::span<const Nanoseconds> times) {
  if (turn_.empty()) return;
  turns_room_.assign(samples.size(), kNoArrival);
  in_cycle_room_.assign(samples.size(), kNoArrival);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!is_known(samples[i])) continue;
    const auto passed = dc::sync0_arrival({samples[i].sync_base, cycle_time_}, samples[i].reference_time);
    turns_room_[i] = static_cast<float>(((passed.number % turns_) + turns_) % turns_);
    in_cycle_room_[i] = static_cast<float>(passed.phase);
  }
  turn_.front().append(times, turns_room_);
  in_cycle_.front().append(times, in_cycle_room_);
}

void ArrivalSeries::leave_gap(Nanoseconds time) {
  for (auto* series : {&turn_, &in_cycle_}) {
    if (!series->empty()) series->front().append(time, kNoArrival);
  }
}

/// What was made reaches beyond the end only as far as nothing has to be added to it before that is shown again.
void ArrivalSeries::show_until(Nanoseconds time) {
  for (auto* series : {&turn_, &in_cycle_}) {
    if (!series->empty()) series->front().show_until(time);
  }
  for (auto& [slave, made] : made_) made.series.show_until(time);
}

const MinMaxSeries& ArrivalSeries::phase(std::size_t slave, const MinMaxSeries& delays) {
  if (slave >= slaves_.size() || slaves_[slave].period <= 0 || turn_.empty()) return none_;
  auto& made = made_for(slave);
  made.asked = ++asked_;
  if (!in_cycle_.front().empty() && made.done < in_cycle_.front().last_time()) extend(made, slaves_[slave], delays);
  return made.series;
}

ArrivalSeries::Made& ArrivalSeries::made_for(std::size_t slave) {
  if (const auto found = made_.find(slave); found != made_.end()) return found->second;
  if (made_.size() >= kMostKept) {
    made_.erase(std::ranges::min_element(made_, {}, [](const auto& made) { return made.second.asked; }));
  }
  return made_.emplace(slave, Made{MinMaxSeries(capacity_)}).first->second;
}

void ArrivalSeries::extend(Made& made, const Sync0Slave& slave, const MinMaxSeries& delays) {
  const auto from = std::max(made.done == INT64_MIN ? INT64_MIN : made.done + 1, in_cycle_.front().first_time());
  turns_room_.clear();
  turn_.front().for_each(from, INT64_MAX, [this](Nanoseconds, float turn) { turns_room_.push_back(turn); });
  Steps delay(delays, from);
  std::size_t i = 0;
  in_cycle_.front().for_each(from, INT64_MAX, [&](Nanoseconds time, float in_cycle) {
    const auto turn = turns_room_[i++];
    const auto late = delay.at(time);
    if (std::isnan(in_cycle) || std::isnan(late)) return made.series.append(time, kNoArrival);
    const auto passed = static_cast<Nanoseconds>(turn) * cycle_time_ + static_cast<Nanoseconds>(in_cycle);
    const auto came = dc::outputs_arrival(passed, static_cast<Nanoseconds>(late), slave.wire);
    made.series.append(time, static_cast<float>(dc::sync0_arrival({slave.shift, slave.period}, came).phase));
  });
  made.done = in_cycle_.front().last_time();
}

std::size_t ArrivalSeries::memory_bytes() const {
  std::size_t bytes = 0;
  for (const auto& series : turn_) bytes += series.memory_bytes();
  for (const auto& series : in_cycle_) bytes += series.memory_bytes();
  for (const auto& [slave, made] : made_) bytes += made.series.memory_bytes();
  return bytes;
}

}  // namespace syncline
