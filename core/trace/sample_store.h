// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "channels/values/stamp_source.h"
#include "trace/arrival_series.h"
#include "trace/held_series.h"
#include "trace/min_max_series.h"
#include "trace/setpoint_slips.h"
#include "trace/signals.h"
#include "trace/watch_lists.h"

namespace syncline {

struct CycleSample;
struct Event;
struct Snapshot;

/// The AL status of its slave that an event tells; nothing where it tells none.
[[nodiscard]] std::optional<std::uint16_t> told_al_status(const Event& event);

/// The signals of a run (core/trace/signals.h), as series that plots and reports read. Time is the host clock's send
/// time. Lost frames, values that were not valid and cycles that are missing in the stream (ring overruns) are gaps.
/// Not thread-safe: lives where the samples are drained.
class SampleStore {
 public:
  struct Layout {
    std::size_t slaves = 0;
    Nanoseconds cycle_time = kMillisecond;
    std::size_t cycle_capacity = 1U << 20;       // cycles that are kept
    std::size_t clocks = 0;                      // slaves whose 0x092C is read in turn; 0: may be all
    std::size_t reading_capacity = 0;            // readings of each that are kept; 0: as many as all cycles bring
    std::size_t held_capacity = 0;               // changes of a count or a state that are kept, at least 8192
    std::uint16_t speed_counter_start = 0x1000;  // register 0x0930
    std::vector<Sync0Slave> sync0{};             // by position; what is not there has no arrival phase and no slips
    Nanoseconds sync_grid = 0;                   // see sync_grid(); 0: not known
  };
  /// One slave is read in each cycle: of each of the clocks `cycle_capacity` divided by their number is kept where
  /// `reading_capacity` does not say otherwise, 8192 at least, so that they reach as far back as the cycles.
  explicit SampleStore(const Layout& layout);

  void append(std::span<const CycleSample> samples);
  /// The samples of the next list of watched variables may come from now on; see WatchLists::add().
  bool watch(std::span<const WatchedVariable> variables);
  /// All that were watched, in the order in which they came: a variable's number is that of its series.
  [[nodiscard]] const WatchLists& watched() const { return watched_; }
  /// So many cycles are going to come, see MinMaxSeries::reserve().
  void reserve(std::size_t cycles);
  /// Counts and states; the samples that came before it first.
  void append(const Snapshot& snapshot);
  /// Changes of a slave's AL status, in the cycle that saw them: a fall that no snapshot has met is among them. They
  /// count from the next snapshot on, which is best the one that came with them.
  void append(const Event& event);

  /// What a recording holds of a held signal, in place of what is there: its changes, not-a-number where nothing is
  /// known from then on, and until when the last one holds.
  void restore(Signal signal, std::size_t slave, std::span<const Nanoseconds> times, std::span<const float> values,
               Nanoseconds until);

  /// Of a run that is complete, as it was at a moment: what is later is there for nobody, until the next call;
  /// INT64_MAX: all is. Nothing may be appended while something is hidden. In time that does not depend on how much
  /// that is.
  void show_until(Nanoseconds time);
  /// The first cycle later than `time`, also a hidden one; nothing behind the last.
  [[nodiscard]] std::optional<Nanoseconds> next_cycle_time(Nanoseconds time) const { return axis().next_value(time); }
  /// The latest cycle at or before `time`; nothing before the first.
  [[nodiscard]] std::optional<Nanoseconds> cycle_time_at(Nanoseconds time) const;

  /// Of a signal that is drawn (not SignalInfo::Form::kCell), of the bus, of one slave or of one variable, by their
  /// numbers. Of variables they are exact up to 2^24, above that to seven digits, and stay where they are. What is
  /// derived is made now, and stays for as long as ArrivalSeries says.
  [[nodiscard]] const MinMaxSeries& series(Signal signal) const;
  [[nodiscard]] const MinMaxSeries& series(Signal signal, std::size_t slave) const;
  /// The same of a held signal, with how long its last value holds; null for the others.
  [[nodiscard]] const HeldSeries* held(Signal signal, std::size_t slave = 0) const;
  /// Until when the last value of a held signal holds; of the others the time of their last sample.
  [[nodiscard]] Nanoseconds heard(Signal signal) const;
  [[nodiscard]] Nanoseconds heard(Signal signal, std::size_t slave) const;
  /// Two neighbouring samples further apart than this have a gap between them, and an older one is no present value.
  [[nodiscard]] Nanoseconds longest_gap(Signal signal) const;
  /// The value at `time` with the time of its reading; nothing where the latest is too old for that.
  [[nodiscard]] std::optional<MinMaxSeries::Reading> value(Signal signal, Nanoseconds time) const;
  [[nodiscard]] std::optional<MinMaxSeries::Reading> value(Signal signal, std::size_t slave, Nanoseconds time) const;

  [[nodiscard]] std::size_t slave_count() const { return layout_.slaves; }
  /// Empty where its arrivals are not known.
  [[nodiscard]] Sync0Slave sync0(std::size_t slave) const;
  [[nodiscard]] bool empty() const { return axis().empty(); }
  [[nodiscard]] Nanoseconds first_time() const { return axis().first_time(); }
  [[nodiscard]] Nanoseconds last_time() const { return axis().last_time(); }
  /// The number of the latest cycle at or before `time`; nothing where none is kept.
  [[nodiscard]] std::optional<std::uint64_t> cycle_at(Nanoseconds time) const;
  /// Who stamped the newest cycle.
  [[nodiscard]] StampSource stamped_by() const { return stamped_by_; }
  /// Cycles that the stream skipped.
  [[nodiscard]] std::uint64_t missing_cycles() const { return missing_cycles_; }
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  /// Consecutive cycles whose times do not go back.
  void append_run(std::span<const CycleSample> run);
  void append_cycles(std::span<const CycleSample> run);
  void append_variables(std::span<const CycleSample> run, std::span<const Nanoseconds> times, std::span<float> values);
  void append_slaves(const CycleSample& sample);
  /// The counts of setpoint slips as they are at `time`.
  void hear_slips(Nanoseconds time);
  void leave_gap(Nanoseconds time);
  void take_told(Nanoseconds until);
  /// Every cycle has a value of it.
  [[nodiscard]] const MinMaxSeries& axis() const { return of_cycles_[axis_]; }
  [[nodiscard]] std::size_t place(Signal signal, std::size_t slave) const;

  Layout layout_;
  std::size_t axis_ = 0;
  std::vector<std::size_t> places_;  // by signal: of its first series in one of the following
  std::vector<const SignalInfo*> cycles_, readings_, held_, held_by_slave_;
  std::vector<MinMaxSeries> of_cycles_, of_readings_;
  std::vector<HeldSeries> of_held_;
  WatchLists watched_;
  std::deque<MinMaxSeries> of_variables_;
  mutable std::optional<ArrivalSeries> arrivals_;  // always there; makes series when they are asked for
  SetpointSlips slips_;
  struct Told {
    Nanoseconds time = 0;
    std::size_t slave = 0;
    std::uint16_t status = 0;
  };
  std::vector<Told> al_told_;
  std::vector<std::uint8_t> has_clock_;  // by slave, 1: it is one of those that are read in turn
  Nanoseconds clocks_ = 0;               // how many these are
  StampSource stamped_by_ = StampSource::kUntold;
  std::vector<Nanoseconds> run_times_;  // room for one run
  std::vector<float> run_values_;
  /// Last cycles of stretches in which none is missing, behind which some are; without that of the newest one.
  struct StretchEnd {
    Nanoseconds time = 0;
    std::uint64_t cycle = 0;
  };
  std::deque<StretchEnd> stretches_;
  StretchEnd newest_;
  std::optional<StretchEnd> shown_newest_;  // while something is hidden: the last cycle that is not
  std::uint64_t next_cycle_ = 0;
  Nanoseconds next_look_ = 0;
  std::uint32_t lost_in_a_row_ = 0;
  bool any_ = false;
  std::uint64_t missing_cycles_ = 0;
};

}  // namespace syncline
