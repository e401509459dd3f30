// SPDX-License-Identifier: Apache-2.0
#include "trace/run_report.h"

#include <algorithm>
#include <cstdlib>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "config/frame_time.h"
#include "config/hot_connect_groups.h"
#include "config/network_config.h"
#include "dc/sync0_arrival.h"
#include "protocol/assign_activate.h"
#include "trace/sending_time.h"

namespace syncline {

RunRecorder::RunRecorder(const NetworkConfig& config)
    : sync_window_enabled_(config.dc.sync_window.enabled), readings_(config.slaves.size()), history_(config) {
  const auto heads = hot_connect_heads(config.slaves);
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    auto& slave = configured_.emplace_back(configured(config, i));
    slave.optional = heads[i].has_value();
    if (heads[i]) slave.group_head = static_cast<int>(*heads[i]);
  }
  wire_time_ = cycle_need(config).wire;
  if (wire_time_ > 0) first_wire_time_ = wire_time(config.cyclic.front().frames.front());
}

RunReport::Slave RunRecorder::configured(const NetworkConfig& config, std::size_t position) {
  const auto& from = config.slaves[position];
  RunReport::Slave slave;
  slave.position = static_cast<std::uint16_t>(position);
  slave.name = from.name;
  slave.identity = from.identity;
  if (from.previous) {
    slave.parent = from.previous->position;
    slave.parent_port = from.previous->port;
  }
  if (!from.dc || !AssignActivate{from.dc->assign_activate}.sync0()) return slave;
  slave.sync0_cycle = from.dc->cycle_time0 > 0 ? from.dc->cycle_time0 : config.cycle_time();
  slave.sync0_shift = from.dc->shift_time;
  slave.outputs_wire_time = outputs_wire_time(config, position);
  return slave;
}

void RunRecorder::add(std::span<const CycleSample> samples) {
  history_.add(samples);
  for (const auto& sample : samples) {
    lateness_.add(sample.wake_lateness_ns);
    // Before SAFEOP the frame is shorter than the configured one.
    if (sample.round_trip_ns > 0 && sample.master_state >= static_cast<std::uint8_t>(AlState::kSafeop))
      round_trip_ = std::min(round_trip_.value_or(sample.round_trip_ns), Nanoseconds{sample.round_trip_ns});
    note_settled(sample);
    master_settled_ = master_settled_ || sample.master_sync == SyncState::kInSync;
    constexpr auto kMeasured = CycleSample::kDcmActive | CycleSample::kReferenceValid;
    if (master_settled_ && (sample.flags & kMeasured) == kMeasured) dcm_error_.add(sample.dcm_error_ns);
    if (sending_time_matters(sample)) lateness_histogram_.add(sample.wake_lateness_ns);
    if (sample.slave_position < 0 || static_cast<std::size_t>(sample.slave_position) >= readings_.size()) continue;
    auto& readings = readings_[static_cast<std::size_t>(sample.slave_position)];
    // What the reference clock shows, or a slave in front of it, is no deviation from the reference clock.
    if ((sample.flags & CycleSample::kSlaveFollows) == 0) continue;
    if (sample.send_time >= readings.latest_time) {
      readings.latest = sample.slave_deviation_ns;
      readings.latest_time = sample.send_time;
    }
    if (!settled_) continue;
    readings.max = std::max(readings.max.value_or(0), std::abs(sample.slave_deviation_ns));
    readings.settled.add(sample.slave_deviation_ns);
  }
}

/// Between two snapshots all may have been read; the worst of them is the one that the event names.
void RunRecorder::add(const Event& event) {
  history_.add(event);
  const auto* out = event.as<events::SlavesOutOfSync>();
  if (out == nullptr || !settled_ || event.slave < 0 || static_cast<std::size_t>(event.slave) >= readings_.size())
    return;
  auto& max = readings_[static_cast<std::size_t>(event.slave)].max;
  max = std::max(max.value_or(0), static_cast<std::int32_t>(std::min<std::int64_t>(out->deviation_ns, INT32_MAX)));
}

/// A sample tells of one slave's reading; where all were read in one cycle, the snapshot has the others'.
void RunRecorder::add(const Snapshot& snapshot) {
  history_.add(snapshot);
  for (std::size_t i = 0; i < std::min(readings_.size(), snapshot.slaves.size()); ++i) {
    const auto& status = snapshot.slaves[i];
    auto& readings = readings_[i];
    if (!status.follows || !status.deviation_valid || status.deviation_time <= readings.latest_time) continue;
    readings.latest = status.deviation_ns;
    readings.latest_time = status.deviation_time;
    if (settled_) readings.max = std::max(readings.max.value_or(0), std::abs(status.deviation_ns));
  }
}

/// The acquisition is reported by settled_after_ms; the maximum is about all that came afterwards, in sync or not.
/// Where nobody watches the slaves it is over when the master has come in sync, or the machine works.
void RunRecorder::note_settled(const CycleSample& sample) {
  if (is_watched(sample.slaves_sync)) {
    settled_ = settled_ || sample.slaves_sync == SyncState::kInSync;
  } else {
    settled_ = settled_ || sample.master_sync == SyncState::kInSync ||
               sample.master_state == static_cast<std::uint8_t>(AlState::kOp);
  }
}

namespace {

/// From the nominal moment at which the slave has its outputs to its next SYNC0.
Nanoseconds sync0_margin(const RunReport::Slave& slave, Nanoseconds set_value) {
  return dc::nominal_margin(set_value, {slave.sync0_shift + slave.evidence.sync0.off_ns, slave.sync0_cycle},
                            slave.propagation_delay_ns.value_or(0), slave.outputs_wire_time);
}

}  // namespace

RunReport RunRecorder::finish(const Snapshot& snapshot) const {
  RunReport report;
  report.state = snapshot.state;
  report.time = snapshot.time;
  report.cycle_time = snapshot.cycle_time;
  report.wire_time = wire_time_;
  report.first_wire_time = first_wire_time_;
  report.round_trip = round_trip_;
  report.cycles = snapshot.cycles;
  report.wkc_errors = snapshot.wkc_errors;
  report.lost_frames = snapshot.lost_frames;
  report.late_frames = snapshot.late_frames;
  report.overruns = snapshot.overruns;
  report.skipped_cycles = snapshot.skipped_cycles;
  report.dc = snapshot.dc;
  report.dcm = snapshot.dcm;
  report.dcm_error = dcm_error_;
  report.lateness = lateness_;
  report.lateness_histogram = lateness_histogram_;
  report.host = snapshot.host;
  report.sync_window_enabled = sync_window_enabled_;
  report.history = history_.history();
  for (std::size_t i = 0; i < configured_.size(); ++i) {
    auto slave = configured_[i];
    // Who leads by now, or stands in front of who does, has no deviation, whatever it was when it followed.
    if (i < snapshot.slaves.size() && snapshot.slaves[i].deviation_valid && snapshot.slaves[i].follows)
      slave.deviation_ns = readings_[i].latest;
    slave.deviation_max_ns = readings_[i].max;
    slave.deviation = readings_[i].settled;
    if (slave.deviation_max_ns) {
      report.deviation_max_ns = std::max(report.deviation_max_ns.value_or(0), *slave.deviation_max_ns);
    }
    if (i < snapshot.slaves.size()) {
      const auto& status = snapshot.slaves[i];
      slave.present = status.present;
      slave.cable_broken = status.cable_broken;
      slave.absent_since = status.absent_since;
      if (!status.present) slave.deviation_ns.reset();
      slave.al_status = status.al_status;
      slave.al_status_code = status.al_status_code;
      slave.al_status_time = status.al_status_time;
      slave.evidence = status.evidence;
      if (status.sm2_missed.valid || status.sm2_missed.known) slave.sm2_missed = status.sm2_missed;
      if (status.dc_enabled) slave.propagation_delay_ns = status.propagation_delay_ns;
      if (slave.sync0_cycle > 0) slave.sync0_margin = sync0_margin(slave, snapshot.dcm.set_value_ns);
    }
    if (slave.deviation_ns) slave.deviation_time = readings_[i].latest_time;
    report.slaves.push_back(std::move(slave));
  }
  return report;
}

}  // namespace syncline
