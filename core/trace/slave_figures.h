// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "trace/min_max_series.h"
#include "trace/statistics.h"

namespace syncline {

struct NetworkConfig;
class SampleStore;

/// What the clock of a slave has to do with deviations.
enum class ClockRole : std::uint8_t {
  kFollower,   // register 0x092C is its deviation
  kReference,  // of the others' clock: what it shows there is no deviation
  kNoDc,
};
/// By slave. Who was read as a follower is one, whatever the configuration says. `reference`: the position of the clock
/// that runs; -1: that of the configuration.
[[nodiscard]] std::vector<ClockRole> clock_roles(const NetworkConfig& config, const SampleStore& store, int reference);

/// Deviation of one slave over a stretch.
struct SlaveFigures {
  std::optional<MinMaxSeries::Reading> newest;  // at or before the end of the stretch, however old it is
  bool is_present = false;                      // the newest is a present value, see SampleStore::longest_gap()
  Nanoseconds age = 0;                          // of the newest at the end of the stretch
  Statistics statistics;                        // of every reading, signed, ns
  std::uint64_t over = 0;                       // readings whose magnitude is above the limit
  std::optional<std::uint64_t> missed;          // SM2 events in the stretch; nothing: it has no such counter

  /// 0..1; nothing without a reading or a limit.
  [[nodiscard]] std::optional<double> share_over(double limit) const;
};

/// Figures of all slaves over [begin, end), made some slaves at a time. Lives in the thread of the store.
class SlaveFigureRound {
 public:
  /// Begins a round; figures of the one before stay until they are made anew. `limit`: a magnitude in ns, 0: none.
  /// The store must stay until the next aim() or drop().
  void aim(const SampleStore& store, Nanoseconds begin, Nanoseconds end, double limit);
  void drop();
  /// Goes on by about so many readings, by one slave at least; true when the round is complete.
  bool work(std::size_t readings);
  [[nodiscard]] bool complete() const { return next_ >= figures_.size(); }
  /// By slave.
  [[nodiscard]] const std::vector<SlaveFigures>& figures() const { return figures_; }

 private:
  const SampleStore* store_ = nullptr;
  Nanoseconds begin_ = 0, end_ = 0;
  double limit_ = 0;
  std::size_t next_ = 0;
  std::vector<SlaveFigures> figures_;
};

}  // namespace syncline
