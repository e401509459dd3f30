// SPDX-License-Identifier: Apache-2.0
#include "trace/run_report.h"

#include <algorithm>
#include <cstdlib>

namespace syncline {

RunRecorder::RunRecorder(const NetworkConfig& config) : readings_(config.slaves.size()) {
  for (const auto& slave : config.slaves) names_.push_back(slave.name);
}

void RunRecorder::add(std::span<const CycleSample> samples) {
  for (const auto& sample : samples) {
    lateness_.add(sample.wake_lateness_ns);
    note_settled(sample);
    if (sample.slave_position < 0 || static_cast<std::size_t>(sample.slave_position) >= readings_.size()) continue;
    auto& readings = readings_[static_cast<std::size_t>(sample.slave_position)];
    // What the reference clock shows, or a slave in front of it, is no deviation from the reference clock.
    if ((sample.flags & CycleSample::kSlaveFollows) == 0) continue;
    readings.latest = sample.slave_deviation_ns;
    if (settled_) readings.max = std::max(readings.max.value_or(0), std::abs(sample.slave_deviation_ns));
  }
}

/// The acquisition is reported by settled_after_ms; the maximum is about all that came afterwards, in sync or not. Where
/// nobody watches the slaves it is over when the master has come in sync, or the machine works.
void RunRecorder::note_settled(const CycleSample& sample) {
  using Flag = CycleSample::Flag;
  if ((sample.flags & Flag::kDcMonitored) != 0) {
    settled_ = settled_ || (sample.flags & Flag::kDcInSync) != 0;
  } else {
    settled_ = settled_ || (sample.flags & Flag::kDcmInSync) != 0 || sample.master_state == static_cast<std::uint8_t>(AlState::kOp);
  }
}

RunReport RunRecorder::finish(const Snapshot& snapshot) const {
  RunReport report;
  report.state = snapshot.state;
  report.time = snapshot.time;
  report.cycle_time = snapshot.cycle_time;
  report.cycles = snapshot.cycles;
  report.wkc_errors = snapshot.wkc_errors;
  report.lost_frames = snapshot.lost_frames;
  report.late_frames = snapshot.late_frames;
  report.overruns = snapshot.overruns;
  report.skipped_cycles = snapshot.skipped_cycles;
  report.dc = snapshot.dc;
  report.dcm = snapshot.dcm;
  report.lateness = lateness_;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    RunReport::Slave slave;
    slave.position = static_cast<std::uint16_t>(i);
    slave.name = names_[i];
    if (i < snapshot.slaves.size() && snapshot.slaves[i].deviation_valid) slave.deviation_ns = readings_[i].latest;
    slave.deviation_max_ns = readings_[i].max;
    if (slave.deviation_max_ns) {
      report.deviation_max_ns = std::max(report.deviation_max_ns.value_or(0), *slave.deviation_max_ns);
    }
    if (i < snapshot.slaves.size()) {
      const auto& status = snapshot.slaves[i];
      slave.al_status = status.al_status;
      slave.al_status_code = status.al_status_code;
      if (status.sm2_missed.valid) slave.sm2_missed = status.sm2_missed;
      if (status.dc_enabled) slave.propagation_delay_ns = status.propagation_delay_ns;
    }
    report.slaves.push_back(std::move(slave));
  }
  return report;
}

}  // namespace syncline
