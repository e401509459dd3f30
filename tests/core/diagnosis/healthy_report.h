// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "channels/values/miss_cause.h"
#include "config/dcm_settings.h"
#include "diagnosis/run_diagnosis.h"
#include "findings/finding.h"
#include "protocol/al_state.h"
#include "trace/run_history.h"
#include "trace/run_report.h"

/// A run to put something wrong into.
namespace syncline::test {

inline constexpr Nanoseconds kStart = 100 * kSecond;

/// A machine of a terminal and two axes that ran for 20 s without any trouble.
inline RunReport healthy() {
  RunReport report;
  report.state = AlState::kOp;
  report.cycle_time = kMillisecond;
  report.history.begin = kStart;
  report.history.end = report.time = kStart + 20 * kSecond;
  report.history.reached_op = true;
  report.history.slaves.resize(3);
  for (std::uint16_t i = 0; i < 3; ++i) {
    RunReport::Slave slave;
    slave.position = i;
    slave.al_status = static_cast<std::uint16_t>(AlState::kOp);
    slave.present = true;
    slave.parent = i - 1;
    slave.parent_port = 1;
    if (i > 0) {
      slave.sync0_margin = 660 * kMicrosecond;
      slave.sync0_cycle = kMillisecond;
      slave.sm2_missed = Sm2MissedStatus{};
      slave.sm2_missed->valid = slave.sm2_missed->known = true;
      slave.sm2_missed->limit = 9;
    }
    report.slaves.push_back(slave);
  }
  report.sync_window_enabled = true;
  report.dc.enabled = report.dc.monitored = true;
  report.dc.state = SyncState::kInSync;
  report.dc.reference_clock = 0;
  report.dc.limit_ns = 127;
  report.dcm.mode = DcmMode::kBusShift;
  report.dcm.state = SyncState::kInSync;
  for (int i = 0; i < 20000; ++i) {
    report.history.frame_lateness.add(5 * kMicrosecond);
    report.lateness_histogram.add(5 * kMicrosecond);
  }
  return report;
}

/// Of what is found, in its order.
inline std::vector<std::string_view> codes(const RunReport& report) {
  std::vector<std::string_view> all;
  for (const auto& finding : diagnose(report)) all.push_back(finding.code);
  return all;
}

/// So many SM2 events, by this cause.
inline void miss(RunReport& report, std::size_t slave, dc::MissCause cause, std::uint32_t count) {
  auto& status = *report.slaves[slave].sm2_missed;
  status.missed += count;
  status.by_cause[static_cast<std::size_t>(cause)] += count;
  status.integrator_highest = 6;
}

/// Out of OP with this AL status code, so long after the beginning.
inline void fall(RunReport& report, std::size_t slave, Nanoseconds after, std::uint16_t al_status_code = 0x1A) {
  report.slaves[slave].al_status = 0x14;
  report.slaves[slave].al_status_code = al_status_code;
  report.history.slaves[slave].fall = RunHistory::Fall{kStart + after, 0x14, al_status_code};
}

/// For a second, 5 s after the beginning; of nobody with -1.
inline RunHistory::SyncLoss loss(int slave, std::int64_t size) {
  return {kStart + 5 * kSecond, slave, size, dc::SyncObstacle::kNone, kStart + 6 * kSecond};
}

}  // namespace syncline::test
