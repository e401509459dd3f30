// SPDX-License-Identifier: Apache-2.0
#include "trace/csv.h"

#include <fmt/format.h>

#include <iterator>

#include "trace/signals.h"

namespace syncline {

std::string sample_csv_header() {
  return "cycle,send_time_ns,lateness_ns,round_trip_ns,reference_time_ns,dcm_error_ns,dcm_error_filtered_ns,drift_ppm,"
         "dcm_adjust_ns,deviation_ored_ns,slave,slave_deviation_ns,sm2_slave,sm2_missed,wkc_expected,wkc_received,"
         "frame_lost,dc_in_sync,dcm_in_sync,NetworkToSubDeviceClkDiff_ns,MdeviceToNetworkClkDiff_ns,frames_lost,"
         "frame_late_by_ns,skipped_cycles,deviation_ns,slave_follows\n";
}

void append_sample_csv(std::string& out, std::span<const CycleSample> samples) {
  using Flag = CycleSample::Flag;
  const auto when = [](bool valid, auto value) { return valid ? fmt::format("{}", value) : std::string{}; };
  for (const auto& s : samples) {
    const auto has = [&s](Flag flag) { return (s.flags & flag) != 0; };
    const bool lost = has(Flag::kFrameLost);
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", s.cycle,
                   s.send_time, s.wake_lateness_ns, when(!lost, s.round_trip_ns),
                   when(has(Flag::kReferenceValid), s.reference_time), when(has(Flag::kDcmActive), s.dcm_error_ns),
                   when(has(Flag::kDcmActive), s.dcm_error_filtered_ns), when(has(Flag::kDcmActive), s.drift_ppm),
                   when(has(Flag::kDcmActive), s.dcm_adjust_ns), when(has(Flag::kDeviationValid), s.deviation_ored_ns),
                   when(s.slave_position >= 0, s.slave_position), when(s.slave_position >= 0, s.slave_deviation_ns),
                   when(s.sm2_position >= 0, s.sm2_position), when(s.sm2_position >= 0, s.slave_sm2_missed),
                   s.wkc_expected, when(!lost, s.wkc_received), lost ? 1 : 0,
                   when(has(Flag::kDcMonitored), has(Flag::kDcInSync) ? 1 : 0),
                   when(has(Flag::kDcmActive), has(Flag::kDcmInSync) ? 1 : 0));
    for (const auto& signal : clock_difference_signals()) {
      const auto value = signal.value(s);
      out += ',';
      if (value) fmt::format_to(std::back_inserter(out), "{}", *value);
    }
    fmt::format_to(std::back_inserter(out), ",{},{},{},{},{}\n", s.frames_lost,
                   when(has(Flag::kFrameLate), s.late_by_ns), s.skipped_cycles,
                   when(has(Flag::kFollowersRead), s.deviation_ns),
                   when(s.slave_position >= 0, has(Flag::kSlaveFollows) ? 1 : 0));
  }
}

}  // namespace syncline
