// SPDX-License-Identifier: Apache-2.0
#include "master/sync_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "config/dcm_check.h"
#include "dc/plans.h"

namespace syncline {
namespace {

/// Lost frames in a row that say nothing about the clocks yet.
constexpr std::uint32_t kSilentCycles = 50;
/// A slave that does not answer must not keep the others' news.
constexpr Nanoseconds kCulpritPatience = 100 * kMillisecond;

double milliseconds(Nanoseconds time) { return static_cast<double>(time) / static_cast<double>(kMillisecond); }

SyncState state_of(dc::SyncWindowMonitor::State state) {
  switch (state) {
    case dc::SyncWindowMonitor::State::kNotMonitored: return SyncState::kNotMonitored;
    case dc::SyncWindowMonitor::State::kSettling: return SyncState::kBusy;
    case dc::SyncWindowMonitor::State::kInSync: return SyncState::kInSync;
    case dc::SyncWindowMonitor::State::kOutOfSync: return SyncState::kOutOfSync;
  }
  return SyncState::kNotReady;
}

std::int32_t to_32(Nanoseconds value) {
  return static_cast<std::int32_t>(std::clamp<Nanoseconds>(value, INT32_MIN, INT32_MAX));
}

}  // namespace

SyncWatch::SyncWatch(RunState& run) : run_(run), settings_(effective_dcm_settings(run.config().dc.dcm)) {
  if (!run_.config().dc.enabled) settings_.mode = DcmMode::kOff;
  note_settings();
}

void SyncWatch::note_settings() {
  auto& dcm = run_.snapshot.dcm;
  dcm.mode = settings_.mode;
  dcm.control_off = settings_.control_off || settings_.mode == DcmMode::kMasterShiftByApp;
  dcm.set_value_ns = to_32(effective_set_value(settings_, run_.config().cycle_time()));
  dcm.bus_shift_configured = bus_shift_configured(run_.config());
}

void SyncWatch::make_controller() {
  const auto cycle = run_.config().cycle_time();
  controller_ = dc::make_dcm_controller(settings_, cycle, effective_set_value(settings_, cycle), least_set_value_);
}

Status SyncWatch::configure(const DcmSettings& change) {
  auto merged = merge_dcm_settings(settings_, change);
  merged.mode = settings_.mode;
  if (auto status = check_dcm_settings(merged, run_.config().cycle_time()); !status) return status;
  settings_ = merged;
  note_settings();
  if (!controller_) return {};
  make_controller();
  controller_->start(base_, last_reference_, last_host_);
  clear_statistics();
  return {};
}

Nanoseconds SyncWatch::first_cycle(const DcNetwork& network, Nanoseconds earliest) const {
  const auto& config = run_.config();
  if (config.dc.start_time_grid <= 0) return earliest;
  const auto reference = network.reference_time + (earliest - network.host_time);
  const auto cycle = config.cycle_time();
  auto phase = (reference + effective_set_value(settings_, cycle)) % cycle;
  if (phase < 0) phase += cycle;
  return earliest + (phase == 0 ? 0 : cycle - phase);
}

void SyncWatch::start(const DcNetwork& network, Nanoseconds first_cycle) {
  const auto& config = run_.config();
  start_ = first_cycle;
  last_host_ = network.host_time;
  last_reference_ = network.reference_time;
  const auto set_value = effective_set_value(settings_, config.cycle_time());
  const auto first_reference = reference_time_at(first_cycle);
  // The grid is laid where the frames pass anyway: the controller starts with an error near zero.
  // With a grid it lies at its multiples, and the frames were laid to suit that: see first_cycle().
  base_ = config.dc.start_time_grid > 0 ? 0 : (first_reference + set_value) % config.cycle_time();
  Nanoseconds farthest = 0;
  for (const auto& slave : network.slaves) farthest = std::max<Nanoseconds>(farthest, slave.delay_ns);
  least_set_value_ = least_set_value(config, farthest);
  make_controller();
  controller_->start(base_, first_reference, first_cycle);

  auto& dc = run_.snapshot.dc;
  dc.enabled = true;
  dc.reference_clock = network.reference_clock;
  dc.monitored = config.dc.sync_window.enabled && network.synchronised_count() >= 2;
  monitor_ = dc::SyncWindowMonitor(config.dc.sync_window, dc.monitored, first_cycle);
  dc.limit_ns = monitor_.limit_ns();
  dc.state = state_of(monitor_.state());
  run_.snapshot.dcm.state = run_.snapshot.dcm.mode == DcmMode::kOff ? SyncState::kNotMonitored : SyncState::kBusy;
}

bool SyncWatch::slaves_in_sync() const {
  return !run_.snapshot.dc.monitored || run_.snapshot.dc.state == SyncState::kInSync;
}

bool SyncWatch::master_in_sync() const {
  // Nobody is waited for who is not asked to come.
  const auto& dcm = run_.snapshot.dcm;
  return dcm.mode == DcmMode::kOff || dcm.control_off || dcm.state == SyncState::kInSync;
}

std::optional<Nanoseconds> SyncWatch::reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) {
  return controller_ ? controller_->reference_write(send_time, scheduled_time) : std::nullopt;
}

Nanoseconds SyncWatch::observe_cycle(const dc::DcmObservation& observation, CycleSample& sample) {
  if (!controller_) return 0;
  if (observation.reference_time) {
    last_host_ = observation.send_time;
    last_reference_ = *observation.reference_time;
    sample.reference_time = *observation.reference_time;
    sample.flags |= CycleSample::kReferenceValid;
  }
  watch_silence(observation.reference_time.has_value(), observation.send_time);
  const auto action = controller_->observe(observation);
  update_dcm(observation.send_time);
  const auto& dcm = run_.snapshot.dcm;
  sample.dcm_error_ns = dcm.error_ns;
  sample.dcm_error_filtered_ns = dcm.error_filtered_ns;
  sample.drift_ppm = static_cast<float>(dcm.drift_ppm);
  const auto& state = controller_->state();
  sample.dcm_adjust_ns = to_32(state.adjust);
  sample.dcm_output_sum_ns = static_cast<float>(state.output_sum);
  sample.dcm_output_total_ns = state.output_total;
  sample.dcm_error_code = state.error_code;
  if (dcm.mode != DcmMode::kOff) sample.flags |= CycleSample::kDcmActive;
  if (dcm.state == SyncState::kInSync) sample.flags |= CycleSample::kDcmInSync;
  return period_adjust(action.period_adjust);
}

/// An application that moves the timer says so in the channel, and nobody else moves it then.
Nanoseconds SyncWatch::period_adjust(Nanoseconds by_controller) const {
  if (!run_.snapshot.dcm.control_off) return by_controller;
  constexpr double kMostPermil = 20;
  const double wanted = run_.channels().timer_adjust_permil.load(std::memory_order_relaxed);
  const double permil = std::isfinite(wanted) ? std::clamp(wanted, -kMostPermil, kMostPermil) : 0;
  return std::llround(permil * 1e-3 * static_cast<double>(run_.config().cycle_time()));
}

void SyncWatch::update_dcm(Nanoseconds time) {
  const auto& state = controller_->state();
  auto& dcm = run_.snapshot.dcm;
  dcm.error_ns = to_32(state.error);
  dcm.error_filtered_ns = to_32(state.error_filtered);
  dcm.drift_ppm = state.drift_ppm;
  dcm.adjust_permil = static_cast<double>(state.adjust) * 1e3 / static_cast<double>(run_.config().cycle_time());
  if (dcm.mode == DcmMode::kOff) return;
  const bool was_in_sync = dcm.state == SyncState::kInSync;
  if (state.in_sync && led_ && time >= distrusted_until_) {
    dcm.state = SyncState::kInSync;
  } else {
    dcm.state = state.in_sync_after ? SyncState::kOutOfSync : SyncState::kBusy;
  }
  if (state.in_sync_after && led_) {
    dcm.in_sync_after_ms = milliseconds(*state.in_sync_after);
    const auto error = static_cast<double>(state.error);
    ++count_;
    sum_ += error;
    sum_of_squares_ += error * error;
    dcm.error_mean_ns = sum_ / static_cast<double>(count_);
    dcm.error_rms_ns = std::sqrt(sum_of_squares_ / static_cast<double>(count_));
    dcm.error_max_ns = std::max(dcm.error_max_ns, to_32(std::abs(state.error)));
  }
  if (state.error_code != dcm.error_code) {
    dcm.error_code = state.error_code;
    if (state.error_code != 0) {
      run_.event(EventKind::kDcmError, time, -1, state.error_code, std::llround(state.drift_ppm));
    }
  }
  tell_dcm_edges(was_in_sync, time);
}

void SyncWatch::tell_dcm_edges(bool was_in_sync, Nanoseconds time) {
  const auto& dcm = run_.snapshot.dcm;
  const bool in_sync = dcm.state == SyncState::kInSync;
  if (in_sync != was_in_sync) run_.event(EventKind::kDcmSync, time, -1, in_sync ? 1 : 0, dcm.error_ns);
}

void SyncWatch::observe_deviation(Nanoseconds time, std::uint32_t ored_ns, CycleSample& sample) {
  auto& dc = run_.snapshot.dc;
  dc.deviation_ored_ns = ored_ns;
  sample.deviation_ored_ns = ored_ns;
  sample.flags |= CycleSample::kDeviationValid;
  const auto edge = monitor_.observe(time, ored_ns);
  dc.state = state_of(monitor_.state());
  if (!led_ && dc.monitored) dc.state = SyncState::kOutOfSync;
  if (const auto settled = monitor_.settled_after()) dc.settled_after_ms = milliseconds(*settled);
  tell_slave_edge(edge, time, ored_ns);
}

void SyncWatch::tell_slave_edge(dc::SyncWindowMonitor::Edge edge, Nanoseconds time, std::uint32_t ored_ns) {
  if (edge == dc::SyncWindowMonitor::Edge::kInSync) {
    if (out_since_) tell_culprit(*out_since_ + kCulpritPatience);
    run_.event(EventKind::kDcSlaveSync, time, -1, 1, ored_ns);
  } else if (edge == dc::SyncWindowMonitor::Edge::kOutOfSync) {
    out_since_ = time;
    out_by_ = ored_ns;
  }
  tell_culprit(time);
}

/// The wire-ored value names nobody: told when every slave has been read since.
void SyncWatch::tell_culprit(Nanoseconds time) {
  if (!out_since_) return;
  const bool all_read = std::ranges::all_of(run_.snapshot.slaves, [this](const SlaveStatus& slave) {
    return !slave.present || !slave.dc_enabled || (slave.deviation_valid && slave.deviation_time > *out_since_);
  });
  if (!all_read && time - *out_since_ < kCulpritPatience) return;
  run_.event(EventKind::kDcSlaveSync, *out_since_, culprit(), 0, out_by_);
  out_since_.reset();
}

void SyncWatch::leader_lost(Nanoseconds time) {
  if (!controller_ || !led_) return;
  led_ = false;
  auto& snapshot = run_.snapshot;
  const bool was_in_sync = snapshot.dcm.state == SyncState::kInSync;
  if (snapshot.dcm.mode != DcmMode::kOff) snapshot.dcm.state = SyncState::kOutOfSync;
  if (was_in_sync) tell_dcm_edges(true, time);
  if (snapshot.dc.monitored) snapshot.dc.state = SyncState::kOutOfSync;
}

void SyncWatch::leader_found(std::uint16_t position, Nanoseconds time) {
  if (!controller_) return;
  led_ = true;
  silent_cycles_ = 0;
  distrusted_until_ = time + settings_.in_sync_settle_time_ms * kMillisecond;
  run_.snapshot.dc.reference_clock = position;
}

/// A reference clock whose time does not come any more is as good as lost, whatever the reason.
void SyncWatch::watch_silence(bool answered, Nanoseconds time) {
  if (answered) {
    if (silent_cycles_ >= kSilentCycles && led_) distrusted_until_ = time + settings_.in_sync_settle_time_ms * kMillisecond;
    silent_cycles_ = 0;
  } else if (silent_cycles_ < kSilentCycles && ++silent_cycles_ == kSilentCycles) {
    distrusted_until_ = INT64_MAX;
  }
}

int SyncWatch::culprit() const {
  int worst = -1;
  std::int32_t largest = 0;
  for (std::size_t i = 0; i < run_.snapshot.slaves.size(); ++i) {
    const auto& slave = run_.snapshot.slaves[i];
    if (!slave.deviation_valid || std::abs(slave.deviation_ns) <= largest) continue;
    largest = std::abs(slave.deviation_ns);
    worst = static_cast<int>(i);
  }
  return worst;
}

Nanoseconds SyncWatch::reference_time_at(Nanoseconds host_time) const {
  return last_reference_ + (host_time - last_host_);
}

Nanoseconds SyncWatch::extend(std::uint32_t low, Nanoseconds send_time) const {
  return dc::extend_32bit(low, reference_time_at(send_time));
}

void SyncWatch::clear_statistics() {
  count_ = 0;
  sum_ = sum_of_squares_ = 0;
  run_.snapshot.dcm.error_mean_ns = run_.snapshot.dcm.error_rms_ns = 0;
  run_.snapshot.dcm.error_max_ns = 0;
}

}  // namespace syncline
