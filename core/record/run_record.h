// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "channels/event.h"
#include "channels/snapshot.h"
#include "config/network_config.h"
#include "findings/finding.h"
#include "record/run_limits.h"
#include "record/run_note.h"
#include "trace/kept_trigger.h"
#include "trace/reference_times.h"
#include "trace/run_report.h"
#include "trace/sample_store.h"

namespace syncline {

struct CycleSample;
struct SyncOverview;
class OverviewRecorder;

/// One run: the configuration that runs and whatever came of it, for as long as somebody looks. Owned by who runs it;
/// plots, tables, exports and recordings read here. Not thread-safe: lives where the channels are drained.
class RunRecord {
 public:
  static constexpr std::size_t kMostEvents = 1U << 16;
  static constexpr std::size_t kMostTriggers = 16;

  /// `cycle_capacity` cycles of samples are kept; 0: as many as suit the cycle time.
  explicit RunRecord(const NetworkConfig& config, std::size_t cycle_capacity = 0);
  /// The same with the limits of a recording, which its configuration does not hold.
  RunRecord(NetworkConfig config, std::size_t cycle_capacity, const RunLimits& limits,
            std::uint16_t speed_counter_start);
  ~RunRecord();
  RunRecord(const RunRecord&) = delete;
  RunRecord& operator=(const RunRecord&) = delete;

  /// Everything that is drained; the samples before the snapshot that came with them.
  void add(std::span<const CycleSample> samples);
  void add(const Snapshot& snapshot);
  void add(const Event& event);
  void add(RunNote note);
  /// In place of all there are.
  void set_notes(std::vector<RunNote> notes);
  /// Samples of the next list of watched variables may come from now on; the master is told by watched().command().
  /// False, and nothing is changed, where it cannot be: see WatchLists::add().
  bool watch(std::span<const WatchedVariable> variables) { return samples_.watch(variables); }
  /// What a trigger has found by now, in place of what it had, in whatever mode.
  void keep(KeptTrigger found);
  /// The latest kMostTriggers, in the order in which they were set.
  [[nodiscard]] const std::vector<KeptTrigger>& triggers() const { return triggers_; }
  /// LINK text of the bus that it is of; "" where nobody knows.
  void set_link(std::string link) { link_ = std::move(link); }
  /// No machine, but a simulated one: its clock need not be the wall's.
  [[nodiscard]] bool simulated() const { return link_.starts_with("sim:"); }
  /// So many cycles are going to come.
  void reserve(std::size_t cycles) { samples_.reserve(cycles); }
  /// Out of a recording, see SampleStore::restore().
  void restore(Signal signal, std::size_t slave, std::span<const Nanoseconds> times, std::span<const float> values) {
    samples_.restore(signal, slave, times, values, samples_.last_time());
  }
  void restore(std::vector<Finding> findings) { restored_findings_ = std::move(findings); }
  /// Of a recording, which is complete: as it was at `time` (host clock). Samples, events and the overview are those of
  /// that moment until another one is shown or show_whole(); what is found is told at its end alone. `overview`: that
  /// of the moment (RunReplay makes it), which must outlive it. Nothing may be added meanwhile.
  void show_at(Nanoseconds time, const SyncOverview& overview);
  void show_whole();
  /// The moment; nothing: all is shown.
  [[nodiscard]] std::optional<Nanoseconds> shown_at() const { return shown_at_; }
  /// Figures and faults of the overview begin anew.
  void arm();
  /// Of a recording: see OverviewRecorder::arm_from().
  void arm_from(Nanoseconds time);

  [[nodiscard]] const NetworkConfig& config() const { return config_; }
  /// Those in force: the running master may be given other parameters.
  [[nodiscard]] const RunLimits& limits() const { return limits_; }
  [[nodiscard]] RunStanding standing() const;
  /// As the configuration names it; its number where there is none.
  [[nodiscard]] std::string slave_name(std::size_t position) const;
  [[nodiscard]] const SampleStore& samples() const { return samples_; }
  [[nodiscard]] const ReferenceTimes& reference_times() const { return reference_times_; }
  [[nodiscard]] const WatchLists& watched() const { return samples_.watched(); }
  /// The newest while the bus was online; empty before.
  [[nodiscard]] const Snapshot& snapshot() const { return snapshot_; }
  /// In their order, the latest kMostEvents.
  [[nodiscard]] const std::deque<Event>& events() const { return events_; }
  [[nodiscard]] std::uint64_t forgotten_events() const { return forgotten_events_; }
  /// By their times.
  [[nodiscard]] const std::vector<RunNote>& notes() const { return notes_; }
  /// Another number when they have changed.
  [[nodiscard]] std::uint64_t notes_changed() const { return notes_changed_; }
  [[nodiscard]] RunReport report() const { return recorder_.finish(snapshot_); }
  [[nodiscard]] const SyncOverview& overview() const;
  /// What makes the overview, as far as it has come.
  [[nodiscard]] const OverviewRecorder& overview_recorder() const { return *overview_; }
  /// What the figures mean. Judged is what was in OP: on the way there everything is unfinished. Of a recording: what
  /// was found while it ran, which is known of its end. Moments count from the first sample on, as the axis of the
  /// plots does.
  [[nodiscard]] std::vector<Finding> findings() const;
  /// The same with moments that count from `told_from` on (host clock): for a recording that began later.
  [[nodiscard]] std::vector<Finding> findings(Nanoseconds told_from) const;

 private:
  void show_events(Nanoseconds until);

  NetworkConfig config_;
  std::string link_;
  RunLimits limits_;
  SampleStore samples_;
  ReferenceTimes reference_times_;
  RunRecorder recorder_;
  std::unique_ptr<OverviewRecorder> overview_;
  std::optional<std::vector<Finding>> restored_findings_;
  Snapshot snapshot_;
  std::deque<Event> events_;
  std::vector<Event> hidden_events_;  // behind those, the next one last
  std::optional<Nanoseconds> shown_at_;
  const SyncOverview* shown_overview_ = nullptr;
  std::uint64_t forgotten_events_ = 0;
  std::vector<RunNote> notes_;
  std::uint64_t notes_changed_ = 0;
  std::vector<KeptTrigger> triggers_;
};

}  // namespace syncline
