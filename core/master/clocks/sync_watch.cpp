// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/sync_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "channels/cycle_sample.h"
#include "channels/master_channels.h"
#include "channels/snapshot.h"
#include "channels/sync_standing.h"
#include "compile/dcm_check.h"
#include "config/network_config.h"
#include "dc/clock_registers.h"
#include "master/clocks/dc_setup.h"
#include "master/clocks/ored_deviation.h"
#include "master/exchange/event_teller.h"
#include "master/exchange/narrow.h"
#include "master/exchange/slave_states.h"
#include "settings/dc_check.h"

namespace syncline {
namespace {

/// Without the reference clock's time for so long, and for so many cycles, it is as good as lost, whatever the reason.
constexpr Nanoseconds kLeastStale = 50 * kMillisecond;
constexpr int kStaleCycles = 10;
/// More is no drift of quartzes.
constexpr double kMaxDriftPpm = 1'000;

}  // namespace

SyncWatch::SyncWatch(const NetworkConfig& config, Snapshot& snapshot, const SlaveStates& states, EventTeller& teller,
                     const std::atomic<double>& timer_adjust_permil)
    : config_(config),
      snapshot_(snapshot),
      teller_(teller),
      timer_adjust_permil_(timer_adjust_permil),
      settings_(effective_dcm_settings(config.dc.dcm)),
      slaves_(config, snapshot, states, teller) {
  if (!config_.dc.enabled) settings_.mode = DcmMode::kOff;
  note_settings();
}

void SyncWatch::note_settings() {
  auto& dcm = snapshot_.dcm;
  dcm.mode = settings_.mode;
  dcm.control_off = settings_.control_off || settings_.mode == DcmMode::kMasterShiftByApp;
  dcm.set_value_ns = to_32(set_value());
  dcm.in_sync_limit = settings_.in_sync_limit;
  dcm.bus_shift_configured = bus_shift_configured(config_);
}

void SyncWatch::make_controller() {
  const auto cycle = config_.cycle_time();
  controller_ = dc::make_dcm_controller(settings_, cycle, set_value(), least_set_value_);
}

Status SyncWatch::configure(const DcmSettings& change) {
  auto merged = merge_dcm_settings(settings_, change);
  merged.mode = settings_.mode;
  if (auto status = check_dcm_settings(merged, config_.cycle_time()); !status) return status;
  settings_ = merged;
  learned_ppm_ = 0;
  note_settings();
  ++snapshot_.dcm.times_configured;
  if (!controller_) return {};
  make_controller();
  controller_->start(base_, last_reference_, last_host_);
  start_verdict(last_host_);
  // Who changes the controller waits for it to settle again: nothing has gone wrong, and nothing is told.
  if (snapshot_.dcm.mode != DcmMode::kOff) snapshot_.dcm.state = SyncState::kBusy;
  clear_statistics();
  return {};
}

void SyncWatch::start_verdict(Nanoseconds time) {
  const auto cycle = config_.cycle_time();
  dc::MasterVerdict::Settings settings;
  settings.settle = settings_.in_sync_settle_time_ms * kMillisecond;
  settings.stale = std::max(kLeastStale, kStaleCycles * cycle);
  settings.late_allowed = set_value() - least_set_value_;
  verdict_ = dc::MasterVerdict(settings, time);
  start_ = time;
  snapshot_.dcm.in_sync_after_ms.reset();
  snapshot_.dcm.late_allowed_ns = to_32(settings.late_allowed);
}

Nanoseconds SyncWatch::set_value() const {
  return effective_set_value(settings_, config_.cycle_time(), least_set_value_);
}

Nanoseconds SyncWatch::first_cycle(const DcNetwork& network, Nanoseconds earliest) {
  const auto& config = config_;
  Nanoseconds farthest = 0;
  for (const auto& slave : network.slaves) farthest = std::max<Nanoseconds>(farthest, slave.delay_ns);
  least_set_value_ = least_set_value(config, farthest);
  if (config.dc.start_time_grid <= 0) return earliest;
  const auto reference = network.reference_time + (earliest - network.host_time);
  const auto cycle = config.cycle_time();
  const auto phase = (reference + set_value()) % cycle;
  return earliest + (phase > 0 ? cycle - phase : -phase);
}

void SyncWatch::start(const DcNetwork& network, Nanoseconds first_cycle) {
  const auto& config = config_;
  start_ = first_cycle;
  last_host_ = network.host_time;
  last_reference_ = network.reference_time;
  line_.start(last_host_, last_reference_);
  const auto first_reference = reference_time_at(first_cycle);
  // The grid is laid where the frames pass anyway: the controller starts with an error near zero.
  // With a grid it lies at its multiples, and the frames were laid to suit that: see first_cycle().
  base_ = config.dc.start_time_grid > 0 ? 0 : (first_reference + set_value()) % config.cycle_time();
  note_settings();
  make_controller();
  controller_->start(base_, first_reference, first_cycle);

  start_verdict(first_cycle);
  snapshot_.dc.enabled = true;
  snapshot_.dc.sync_base = base_;
  slaves_.start(network, first_cycle, steers());
  led_ = true;
  snapshot_.dcm.state = snapshot_.dcm.mode == DcmMode::kOff ? SyncState::kNotMonitored : SyncState::kBusy;
}

bool SyncWatch::slaves_in_sync() const {
  return !snapshot_.dc.monitored || syncline::slaves_in_sync(snapshot_.dc).value_or(true);
}

bool SyncWatch::schedule_in_sync() const {
  // Nobody is waited for who is not asked to come.
  const auto& dcm = snapshot_.dcm;
  return dcm.mode == DcmMode::kOff || dcm.control_off || verdict_.schedule_in_sync();
}

std::optional<Nanoseconds> SyncWatch::reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) {
  return controller_ ? controller_->reference_write(send_time, scheduled_time) : std::nullopt;
}

Nanoseconds SyncWatch::observe_cycle(const dc::DcmObservation& observation, CycleSample& sample) {
  if (!controller_) return 0;
  sample.sync_base = base_;
  sample.flags |= CycleSample::kSyncBaseValid;
  if (observation.reference_time) {
    last_host_ = observation.send_time;
    last_reference_ = *observation.reference_time;
    line_.observe(last_host_, last_reference_);
    sample.reference_time = *observation.reference_time;
    sample.flags |= CycleSample::kReferenceValid;
  }
  const auto action = controller_->observe(observation);
  write_again_ = action.write_again;
  update_dcm(observation, sample.skipped_cycles);
  const auto& dcm = snapshot_.dcm;
  sample.dcm_error_ns = dcm.error_ns;
  sample.dcm_error_filtered_ns = dcm.error_filtered_ns;
  sample.drift_ppm = static_cast<float>(dcm.drift_ppm);
  const auto& state = controller_->state();
  sample.dcm_adjust_ns = to_32(state.adjust);
  sample.dcm_output_sum_ns = static_cast<float>(state.output_sum);
  sample.dcm_output_total_ns = state.output_total;
  sample.dcm_error_code = state.error_code;
  // An external clock is looked at beside the reference clock: without a reading of that one there is nothing to say.
  if (observation.reference_time && dcm.external_error_ns) sample.external_error_ns = *dcm.external_error_ns;
  if (dcm.mode != DcmMode::kOff) sample.flags |= CycleSample::kDcmActive;
  sample.master_sync = dcm.state;
  return period_adjust(action.period_adjust);
}

bool SyncWatch::observe_second_write(const dc::DcmObservation& observation) {
  return controller_ && controller_->observe_second_write(observation);
}

/// An application that moves the timer says so in the channel, and nobody else moves it then.
Nanoseconds SyncWatch::period_adjust(Nanoseconds by_controller) const {
  if (!snapshot_.dcm.control_off) return by_controller;
  constexpr double kMostPermil = 20;
  const double wanted = timer_adjust_permil_.load(std::memory_order_relaxed);
  const double permil = std::isfinite(wanted) ? std::clamp(wanted, -kMostPermil, kMostPermil) : 0;
  return std::llround(permil * 1e-3 * static_cast<double>(config_.cycle_time()));
}

void SyncWatch::update_dcm(const dc::DcmObservation& observation, std::int64_t skipped) {
  const auto& state = controller_->state();
  auto& dcm = snapshot_.dcm;
  dcm.error_ns = to_32(state.error);
  dcm.error_filtered_ns = to_32(state.error_filtered);
  dcm.drift_ppm = state.drift_ppm + learned_ppm_;
  // What a register of the clock has told is no measurement of ours.
  if (learned_ppm_ == 0) {
    dcm.drift_half_width_ppm = state.drift_half_width_ppm;
  } else {
    dcm.drift_half_width_ppm.reset();
  }
  dcm.adjust_permil = static_cast<double>(state.adjust) * 1e3 / static_cast<double>(config_.cycle_time());
  // Where the frame was lost the schedule's error is known from the cycles before.
  const auto schedule_error = observation.reference_time ? state.error : state.error_filtered;
  // In the grid: a clock that has stepped by whole cycles makes no frame late.
  dcm.frame_error_ns = to_32(dc::wrap_to_half(schedule_error, config_.cycle_time()) +
                             (observation.send_time - observation.scheduled_time) - state.usual_lateness);
  dcm.external_error_ns.reset();
  if (state.external_error) dcm.external_error_ns = to_32(*state.external_error);
  if (dcm.mode == DcmMode::kOff) return;
  if (state.error_code != dcm.error_code) {
    dcm.error_code = state.error_code;
    if (state.error_code != 0) {
      teller_.tell(observation.send_time, -1, events::DcmError{state.error_code, std::llround(state.drift_ppm)});
    }
  }
  judge_master(observation, skipped);
  if (state.in_sync_after && led_) count_errors();
}

void SyncWatch::judge_master(const dc::DcmObservation& observation, std::int64_t skipped) {
  const auto& state = controller_->state();
  auto& dcm = snapshot_.dcm;
  const bool was_in_sync = dcm.state == SyncState::kInSync;
  verdict_.observe({.time = observation.send_time,
                    .led = led_,
                    .read = observation.reference_time.has_value(),
                    .schedule_in_sync = state.in_sync,
                    .external = state.external,
                    .clock_stepped = state.clock_step.has_value(),
                    .error_code = state.error_code,
                    .skipped_cycles = skipped,
                    .frame_error = dcm.frame_error_ns});
  dcm.obstacle = verdict_.obstacle();
  if (verdict_.in_sync()) {
    dcm.state = SyncState::kInSync;
    if (!dcm.in_sync_after_ms) dcm.in_sync_after_ms = to_milliseconds(observation.send_time - start_);
  } else {
    // An error is no way to in sync.
    dcm.state = dcm.in_sync_after_ms || state.error_code != 0 ? SyncState::kOutOfSync : SyncState::kBusy;
  }
  const bool in_sync = dcm.state == SyncState::kInSync;
  // A step is told also where its first readings have looked like something else.
  if (in_sync == was_in_sync && !state.clock_step) return;
  auto error = Nanoseconds{dcm.obstacle == dc::SyncObstacle::kLateFrames ? dcm.frame_error_ns : dcm.error_ns};
  if (dc::is_of_external_clock(dcm.obstacle)) error = dcm.external_error_ns.value_or(0);
  // A step by whole cycles leaves no error in the grid.
  if (state.clock_step) error = *state.clock_step;
  if (in_sync) return teller_.tell(observation.send_time, -1, events::MasterInSync{error});
  teller_.tell(observation.send_time, -1, events::MasterOutOfSync{error, dcm.obstacle});
}

void SyncWatch::count_errors() {
  const auto& state = controller_->state();
  auto& dcm = snapshot_.dcm;
  const auto error = static_cast<double>(state.error);
  ++count_;
  sum_ += error;
  sum_of_squares_ += error * error;
  dcm.error_mean_ns = sum_ / static_cast<double>(count_);
  dcm.error_rms_ns = std::sqrt(sum_of_squares_ / static_cast<double>(count_));
  dcm.error_max_ns = std::max(dcm.error_max_ns, to_32(std::abs(state.error)));
  dcm.frame_error_max_ns = std::max(dcm.frame_error_max_ns, std::abs(dcm.frame_error_ns));
  if (verdict_.too_late(dcm.frame_error_ns)) ++dcm.late_sends;
}

void SyncWatch::observe_slaves(Nanoseconds time, std::span<const std::uint16_t> read,
                               const std::optional<OredDeviation>& ored, CycleSample& sample) {
  if (!active()) return;
  slaves_.observe(time, led_, (sample.flags & CycleSample::kReferenceValid) != 0, read, ored, sample);
}

void SyncWatch::leader_lost(Nanoseconds) { led_ = false; }

void SyncWatch::leader_found(std::uint16_t position, Nanoseconds time, bool substitute) {
  if (!controller_) return;
  controller_->set_led_by_substitute(substitute);
  controller_->note_other_way();
  led_ = true;
  line_.start_place_anew();
  verdict_.distrust(time);
  snapshot_.dc.reference_clock = position;
}

void SyncWatch::way_changed() {
  slaves_.note_other_way();
  if (controller_) controller_->note_other_way();
}

void SyncWatch::leader_moved(std::uint16_t position) {
  if (!controller_) return;
  controller_->set_led_by_substitute(false);
  controller_->note_other_way();
  snapshot_.dc.reference_clock = position;
}

Nanoseconds SyncWatch::reference_time_at(Nanoseconds host_time) const {
  // After seconds of silence a quartz is far away from where the host's would be.
  return line_.at(host_time, std::clamp(snapshot_.dcm.drift_ppm, -kMaxDriftPpm, kMaxDriftPpm));
}

Nanoseconds SyncWatch::extend(std::uint32_t low, Nanoseconds send_time) const {
  return dc::extend_32bit(low, reference_time_at(send_time));
}

void SyncWatch::clear_statistics() {
  count_ = 0;
  sum_ = sum_of_squares_ = 0;
  snapshot_.dcm.error_mean_ns = snapshot_.dcm.error_rms_ns = 0;
  snapshot_.dcm.error_max_ns = 0;
  snapshot_.dcm.frame_error_max_ns = 0;
  snapshot_.dcm.late_sends = 0;
}

}  // namespace syncline
