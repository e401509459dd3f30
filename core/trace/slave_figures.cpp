// SPDX-License-Identifier: Apache-2.0
#include "trace/slave_figures.h"

#include <algorithm>
#include <cmath>

#include "config/network_config.h"
#include "trace/sample_store.h"

namespace syncline {
namespace {

std::optional<std::uint64_t> missed_in(const SampleStore& store, std::size_t slave, Nanoseconds begin,
                                       Nanoseconds end) {
  const auto& series = store.series(Signal::kSm2Missed, slave);
  const auto now = series.at(end - 1);
  if (!now) return std::nullopt;
  const auto then = series.at(std::max(begin, series.first_time()));
  if (!then) return std::nullopt;
  // A counter that went back was cleared: what it shows now came since.
  const auto events = now->value < then->value ? now->value : now->value - then->value;
  return static_cast<std::uint64_t>(std::llround(events));
}

SlaveFigures figures_of(const SampleStore& store, std::size_t slave, Nanoseconds begin, Nanoseconds end, double limit) {
  SlaveFigures figures;
  const auto& series = store.series(Signal::kSlaveDeviation, slave);
  const auto present = std::min(end - 1, store.last_time());
  figures.newest = series.at(present);
  figures.is_present = store.value(Signal::kSlaveDeviation, slave, present).has_value();
  if (figures.newest) figures.age = present - figures.newest->time;
  series.for_each(begin, end, [&](Nanoseconds, float value) {
    if (std::isnan(value)) return;
    const auto number = static_cast<double>(value);
    figures.statistics.add(number);
    if (limit > 0 && std::abs(number) > limit) ++figures.over;
  });
  figures.missed = missed_in(store, slave, begin, end);
  return figures;
}

}  // namespace

std::vector<ClockRole> clock_roles(const NetworkConfig& config, const SampleStore& store, int reference) {
  if (reference < 0 && config.reference_clock()) reference = *config.reference_clock();
  std::vector<ClockRole> roles(store.slave_count(), ClockRole::kNoDc);
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (!store.series(Signal::kSlaveDeviation, i).empty()) {
      roles[i] = ClockRole::kFollower;
    } else if (static_cast<int>(i) == reference) {
      roles[i] = ClockRole::kReference;
    } else if (i < config.slaves.size() && config.slaves[i].dc) {
      roles[i] = ClockRole::kFollower;
    }
  }
  return roles;
}

std::optional<double> SlaveFigures::share_over(double limit) const {
  if (limit <= 0 || statistics.count() == 0) return std::nullopt;
  return static_cast<double>(over) / static_cast<double>(statistics.count());
}

void SlaveFigureRound::aim(const SampleStore& store, Nanoseconds begin, Nanoseconds end, double limit) {
  store_ = &store;
  begin_ = begin;
  end_ = end;
  limit_ = limit;
  next_ = 0;
  figures_.resize(store.slave_count());
}

void SlaveFigureRound::drop() {
  store_ = nullptr;
  figures_.clear();
  next_ = 0;
}

bool SlaveFigureRound::work(std::size_t readings) {
  std::size_t done = 0;
  while (!complete() && (done == 0 || done < readings)) {
    auto& figures = figures_[next_];
    figures = figures_of(*store_, next_, begin_, end_, limit_);
    done += std::max<std::size_t>(static_cast<std::size_t>(figures.statistics.count()), 1);
    ++next_;
  }
  return complete();
}

}  // namespace syncline
