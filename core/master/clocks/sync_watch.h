// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "channels/snapshot.h"
#include "dc/dcm/dcm_controller.h"
#include "dc/master_verdict.h"
#include "dc/reference_line.h"
#include "master/clocks/dc_start.h"
#include "master/clocks/slaves_sync.h"

namespace syncline {

struct CycleSample;
struct DcNetwork;
class EventTeller;
struct NetworkConfig;
struct OredDeviation;
class SlaveStates;

/// Both synchronisations of a running bus: slaves to the reference clock (sync window) and master to
/// the reference clock (DCM). Feeds the status, tells the edges.
class SyncWatch {
 public:
  /// `timer_adjust_permil`: MasterChannels::timer_adjust_permil.
  SyncWatch(const NetworkConfig& config, Snapshot& snapshot, const SlaveStates& states, EventTeller& teller,
            const std::atomic<double>& timer_adjust_permil);

  /// First cycle at or behind `earliest` that suits the start time grid: with one, SYNC0 comes at multiples of the
  /// cycle in system time, so that networks whose reference clocks follow one host are in phase; without, `earliest`
  /// itself. Comes before start(): how long the bus is decides where an automatic set value lies.
  [[nodiscard]] Nanoseconds first_cycle(const DcNetwork& network, Nanoseconds earliest);
  /// After the DC initialisation, before the first cyclic frame, which is scheduled for `first_cycle`.
  /// Without distributed clocks it is not called and nothing is watched.
  void start(const DcNetwork& network, Nanoseconds first_cycle);
  [[nodiscard]] bool active() const { return controller_ != nullptr; }
  /// Phase of the SYNC grid in system time: SYNC0 at base + n * cycle.
  [[nodiscard]] Nanoseconds base() const { return base_; }
  [[nodiscard]] bool monitored() const { return snapshot_.dc.monitored; }
  /// For who waits: in sync, or nobody watches.
  [[nodiscard]] bool slaves_in_sync() const;
  /// Somebody left the sync window, or may have: who it is, the slaves' own readings will say.
  [[nodiscard]] bool wants_readings() const { return slaves_.wants_readings(); }
  /// For who waits: the schedule has met the reference clock, or is not asked to. That single frames are late is no
  /// reason to wait.
  [[nodiscard]] bool schedule_in_sync() const;

  /// Value for the reference clock, just before the frame is sent.
  [[nodiscard]] std::optional<Nanoseconds> reference_write(Nanoseconds send_time, Nanoseconds scheduled_time);
  /// One cycle; the result is added to the next period. Fills the sample's DCM fields.
  Nanoseconds observe_cycle(const dc::DcmObservation& observation, CycleSample& sample);
  /// What this cycle has told the reference clock was wrong (DcmAction::write_again), and what another write found.
  [[nodiscard]] bool wants_second_write() const { return write_again_; }
  /// True: that one was wrong, too.
  bool observe_second_write(const dc::DcmObservation& observation);
  /// The same cycle, after observe_cycle() and the readings of the slaves. Fills the sample's DC fields.
  /// `read`: the slaves whose own deviation came with this cycle.
  void observe_slaves(Nanoseconds time, std::span<const std::uint16_t> read, const std::optional<OredDeviation>& ored,
                      CycleSample& sample);
  /// System time of the reference clock at a host time, without the noise of single stamps.
  [[nodiscard]] Nanoseconds reference_time_at(Nanoseconds host_time) const;
  /// The latest reading extended to 64 bit.
  [[nodiscard]] Nanoseconds extend(std::uint32_t low, Nanoseconds send_time) const;
  void clear_statistics();
  /// Other parameters of the running controller; zeros leave what is. Nothing changes when they are refused.
  Status configure(const DcmSettings& change);
  /// The reference clock is told the time: a mode that does so, with control on.
  [[nodiscard]] bool steers() const { return steers_reference_clock(settings_.mode) && !settings_.control_off; }
  /// By how much the time control loop of a clock that is steered no more slows it down, ppm.
  void set_learned_rate(double ppm) { learned_ppm_ = ppm; }
  void set_start_time(DcStartTimeCallback callback) { start_time_ = std::move(callback); }
  [[nodiscard]] const DcStartTimeCallback& start_time() const { return start_time_; }

  /// The reference clock is lost, or another one (or the same again) leads. While nobody leads, and until a new
  /// leader has led for the settle time, nothing counts as in sync.
  void leader_lost(Nanoseconds time);
  /// `substitute`: not the one that is to lead whenever it is there.
  void leader_found(std::uint16_t position, Nanoseconds time, bool substitute);
  /// Slaves in front of the clock that leads have come or gone.
  void way_changed();
  /// The one that is to lead does so again, and went with the one before: nobody has noticed.
  void leader_moved(std::uint16_t position);

 private:
  [[nodiscard]] Nanoseconds set_value() const;
  void update_dcm(const dc::DcmObservation& observation, std::int64_t skipped);
  void judge_master(const dc::DcmObservation& observation, std::int64_t skipped);
  void count_errors();
  void start_verdict(Nanoseconds time);

  void make_controller();
  void note_settings();
  [[nodiscard]] Nanoseconds period_adjust(Nanoseconds by_controller) const;

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  EventTeller& teller_;
  const std::atomic<double>& timer_adjust_permil_;
  DcmSettings settings_;
  Nanoseconds least_set_value_ = 0;  // until outputs are at the last slave
  std::unique_ptr<dc::DcmController> controller_;
  SlavesSync slaves_;
  dc::MasterVerdict verdict_;
  Nanoseconds base_ = 0, start_ = 0;
  Nanoseconds last_host_ = 0, last_reference_ = 0;
  dc::ReferenceLine line_;
  double learned_ppm_ = 0;
  bool led_ = true;  // somebody leads
  bool write_again_ = false;
  std::uint64_t count_ = 0;
  double sum_ = 0, sum_of_squares_ = 0;
  DcStartTimeCallback start_time_;
};

}  // namespace syncline
