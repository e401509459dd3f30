// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "dc/dcm/dcm_controller.h"
#include "dc/sync_window_monitor.h"
#include "master/dc_setup.h"
#include "master/dc_start.h"
#include "master/run_state.h"

namespace syncline {

/// Both synchronisations of a running bus: slaves to the reference clock (sync window) and master to
/// the reference clock (DCM). Feeds the status, tells the edges.
class SyncWatch {
 public:
  explicit SyncWatch(RunState& run);

  /// First cycle at or behind `earliest` that suits the start time grid: with one, SYNC0 comes at multiples of the cycle in
  /// system time, so that networks whose reference clocks follow one host are in phase; without, `earliest` itself.
  [[nodiscard]] Nanoseconds first_cycle(const DcNetwork& network, Nanoseconds earliest) const;
  /// After the DC initialisation, before the first cyclic frame, which is scheduled for `first_cycle`.
  /// Without distributed clocks it is not called and nothing is watched.
  void start(const DcNetwork& network, Nanoseconds first_cycle);
  [[nodiscard]] bool active() const { return controller_ != nullptr; }
  /// Phase of the SYNC grid in system time: SYNC0 at base + n * cycle.
  [[nodiscard]] Nanoseconds base() const { return base_; }
  [[nodiscard]] bool monitored() const { return run_.snapshot.dc.monitored; }
  [[nodiscard]] bool slaves_in_sync() const;
  /// Somebody left the sync window: who it is, the slaves' own readings will say.
  [[nodiscard]] bool looking_for_culprit() const { return out_since_.has_value(); }
  [[nodiscard]] bool master_in_sync() const;

  /// Value for the reference clock, just before the frame is sent.
  [[nodiscard]] std::optional<Nanoseconds> reference_write(Nanoseconds send_time, Nanoseconds scheduled_time);
  /// One cycle; the result is added to the next period. Fills the sample's DC and DCM fields.
  Nanoseconds observe_cycle(const dc::DcmObservation& observation, CycleSample& sample);
  /// One reading of the wire-ored 0x092C.
  void observe_deviation(Nanoseconds time, std::uint32_t ored_ns, CycleSample& sample);
  /// System time of the reference clock at a host time, from the latest reading.
  [[nodiscard]] Nanoseconds reference_time_at(Nanoseconds host_time) const;
  /// The latest reading extended to 64 bit.
  [[nodiscard]] Nanoseconds extend(std::uint32_t low, Nanoseconds send_time) const;
  void clear_statistics();
  /// Other parameters of the running controller; zeros leave what is. Nothing changes when they are refused.
  Status configure(const DcmSettings& change);
  void set_start_time(DcStartTimeCallback callback) { start_time_ = std::move(callback); }
  [[nodiscard]] const DcStartTimeCallback& start_time() const { return start_time_; }

  /// The reference clock is lost, or another one (or the same again) leads. While nobody leads, and until a new
  /// leader has led for the settle time, nothing counts as in sync.
  void leader_lost(Nanoseconds time);
  void leader_found(std::uint16_t position, Nanoseconds time);

 private:
  void update_dcm(Nanoseconds time);
  void watch_silence(bool answered, Nanoseconds time);
  void tell_dcm_edges(bool was_in_sync, Nanoseconds time);
  void tell_slave_edge(dc::SyncWindowMonitor::Edge edge, Nanoseconds time, std::uint32_t ored_ns);
  void tell_culprit(Nanoseconds time);
  [[nodiscard]] int culprit() const;

  void make_controller();
  void note_settings();
  [[nodiscard]] Nanoseconds period_adjust(Nanoseconds by_controller) const;

  RunState& run_;
  DcmSettings settings_;
  Nanoseconds least_set_value_ = 0;
  std::unique_ptr<dc::DcmController> controller_;
  dc::SyncWindowMonitor monitor_;
  Nanoseconds base_ = 0, start_ = 0;
  Nanoseconds last_host_ = 0, last_reference_ = 0;
  std::optional<Nanoseconds> out_since_;  // out of sync, and not told yet
  std::uint32_t out_by_ = 0;
  bool led_ = true;                  // somebody leads
  Nanoseconds distrusted_until_ = 0;
  std::uint32_t silent_cycles_ = 0;  // without the reference clock's time
  std::uint64_t count_ = 0;
  double sum_ = 0, sum_of_squares_ = 0;
  DcStartTimeCallback start_time_;
};

}  // namespace syncline
