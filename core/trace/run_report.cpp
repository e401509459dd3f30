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
    if (sample.slave_position < 0 || static_cast<std::size_t>(sample.slave_position) >= readings_.size()) continue;
    auto& readings = readings_[static_cast<std::size_t>(sample.slave_position)];
    readings.latest = sample.slave_deviation_ns;
    // The acquisition is reported by settled_after_ms; the maximum is about what holds afterwards.
    if ((sample.flags & CycleSample::kDcInSync) != 0) {
      const auto magnitude = std::abs(sample.slave_deviation_ns);
      readings.max_in_sync = std::max(readings.max_in_sync.value_or(0), magnitude);
    }
  }
}

RunReport RunRecorder::finish(const Snapshot& snapshot) const {
  RunReport report;
  report.state = snapshot.state;
  report.cycle_time = snapshot.cycle_time;
  report.cycles = snapshot.cycles;
  report.wkc_errors = snapshot.wkc_errors;
  report.lost_frames = snapshot.lost_frames;
  report.overruns = snapshot.overruns;
  report.dc = snapshot.dc;
  report.dcm = snapshot.dcm;
  report.lateness = lateness_;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    RunReport::Slave slave;
    slave.position = static_cast<std::uint16_t>(i);
    slave.name = names_[i];
    slave.deviation_ns = readings_[i].latest;
    slave.deviation_max_ns = readings_[i].max_in_sync;
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
