// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "channels/cycle_sample.h"
#include "trace/fault_log.h"
#include "trace/histogram.h"
#include "trace/lasting_magnitude.h"
#include "trace/statistics.h"

/// Whether the machine is in sync, since when, with how much margin, and what happened first: what one page shows of a
/// run. Made of samples and events alone, so that a recording gives the same.
namespace syncline {

struct CycleSample;
struct NetworkConfig;

/// One of the two verdicts over time.
struct SyncLamp {
  SyncState state = SyncState::kNotReady;
  Nanoseconds since = 0;                 // host clock: the state is the same since then
  std::optional<Nanoseconds> last_lost;  // when it was left last since it was armed: in sync before, and then not
  std::uint64_t times_lost = 0;          // since it was armed
  /// Of the slaves: the verdict speaks of those who answer. When one that follows the reference clock fell silent last
  /// since it was armed, how often one did while none was away, and since when all of them are within the window again.
  std::optional<Nanoseconds> last_away;
  std::uint64_t times_away = 0;
  Nanoseconds back_since = 0;  // 0: none was away

  /// The state is the same, of all of them, since then.
  [[nodiscard]] Nanoseconds of_all_since() const {
    return state == SyncState::kInSync && back_since > since ? back_since : since;
  }
  /// Both kinds of loss.
  [[nodiscard]] std::optional<Nanoseconds> any_lost() const { return last_lost > last_away ? last_lost : last_away; }
  [[nodiscard]] std::uint64_t times_any_lost() const { return times_lost + times_away; }
};

/// A signal of every cycle as numbers; now at any time, the others since it was armed.
struct OverviewFigure {
  struct Reading {
    Nanoseconds time = 0;  // host clock
    std::int64_t value = 0;
  };
  std::optional<Reading> now;  // the latest valid one: whoever shows it looks at its age
  Statistics statistics;       // signed where the signal is
  Histogram magnitudes;
  std::optional<Reading> largest;  // magnitude

  /// Part of the limit that the largest magnitude has left, negative when it was exceeded; nothing without both.
  [[nodiscard]] std::optional<double> margin(std::int64_t limit) const;
};

struct SyncOverview {
  std::optional<Nanoseconds> armed;  // host clock; nothing: the machine has not been ready yet
  Nanoseconds begin = 0, end = 0;    // of the samples
  AlState state = AlState::kNone;    // of the master, in the newest of them
  SyncLamp slaves, master;
  OverviewFigure deviation;  // ns, largest of the slaves that follow the reference clock, a magnitude
  /// Samples of it, and how many of them are what the wire has or-ed (CycleSample::deviation_ns).
  std::uint64_t deviation_count = 0, deviation_ored = 0;
  OverviewFigure dcm_error;     // ns, signed
  OverviewFigure dcm_filtered;  // ns, signed: what the controller has made of it
  /// Of the filtered error, ns. What is over the limit for a moment is borne by the verdict: the margin of the master
  /// synchronisation is that of what lasted.
  LastingMagnitude dcm_lasting;
  struct Missed {
    std::uint64_t count = 0;  // SM2 events of all slaves since it was armed
    std::optional<Nanoseconds> last;
    std::vector<std::uint64_t> by_slave;
    bool known = false;  // some slave has such a counter
  } missed;
  FaultLog faults;
  std::vector<bool> followed;  // by position: it has followed the reference clock since the run began
  /// `deviation` is an upper estimate: magnitudes are or-ed, not compared, so that no slave is off by more than it
  /// says, and perhaps none by so much. Where single readings are the measure, they are the or-ed value now and then
  /// only.
  [[nodiscard]] bool is_deviation_ored() const { return deviation_ored > 0 && 2 * deviation_ored >= deviation_count; }
};

/// Nothing that is watched is out of sync, or has yet to come: what arming waits for, beside OP.
[[nodiscard]] bool is_ready(SyncState state);

/// Fills one; feed it everything that is drained, samples first. Bring-up is no part of the figures: they begin in OP,
/// once whatever is watched is in sync; which cycles count from then on says trace/counted_cycle.h.
class OverviewRecorder {
 public:
  explicit OverviewRecorder(std::size_t slaves);
  /// Of its slaves, of which those of hot-connect groups may be away.
  explicit OverviewRecorder(const NetworkConfig& config);
  void add(std::span<const CycleSample> samples);
  void add(const Event& event);
  /// Figures, losses and faults begin anew behind the newest sample.
  void arm();
  /// Of a recording: its run was armed last at `time` (host clock). Whatever the samples say, it is armed so at the
  /// first one from then on; before it arms itself, as the run did. INT64_MAX: it was not armed at the end, and is not.
  void arm_from(Nanoseconds time) { armed_from_ = time; }
  /// The machine is held against something else since `time` (host clock): armed anew when it is in sync with that.
  void disarm(Nanoseconds time);
  [[nodiscard]] const SyncOverview& overview() const { return overview_; }

 private:
  void add(const CycleSample& sample);
  void add_missed(const CycleSample& sample);
  /// Who follows the reference clock goes, or is within the sync window again.
  void note_away(const Event& event);
  [[nodiscard]] bool is_to_be_armed(const CycleSample& sample) const;
  void arm_at(Nanoseconds time);
  void begin_anew(Nanoseconds time);

  SyncOverview overview_;
  std::vector<std::optional<std::uint32_t>> counters_;  // of missed SM2 events, as read last
  std::vector<bool> may_be_away_;                       // by position
  std::set<int> away_;                                  // followers that went, until they are in sync again
  std::optional<Nanoseconds> armed_from_;
  Nanoseconds disarmed_ = 0;
  bool any_ = false;
};

}  // namespace syncline
