// SPDX-License-Identifier: Apache-2.0
#include "app/cli/run_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/cli/context.h"
#include "app/cli/evidence_json.h"
#include "app/cli/interval_json.h"
#include "channels/sync_standing.h"
#include "channels/values/sync_obstacle_text.h"
#include "diagnosis/run_diagnosis.h"
#include "findings/finding.h"
#include "protocol/dcm_error.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Three digits are more than any of these figures is worth, and keep the text stable.
Json rounded(double value) { return std::round(value * 1000.0) / 1000.0; }
Json rounded(const std::optional<double>& value) { return value ? rounded(*value) : Json(nullptr); }

/// The mean of `shown` samples may be of some cycles more than that of `statistics`.
Json mean_interval(double shown, const Statistics& statistics) {
  auto interval = statistics.mean_interval();
  if (!interval) return nullptr;
  const double moved = shown - statistics.mean();
  return interval_json(Interval{interval->low + moved, interval->high + moved});
}

Json drift_interval(const DcmStatus& dcm) {
  if (!dcm.drift_half_width_ppm) return nullptr;
  return interval_json(Interval{dcm.drift_ppm - *dcm.drift_half_width_ppm, dcm.drift_ppm + *dcm.drift_half_width_ppm},
                       true);
}

/// Where nobody knows which of the two counters it is, both.
std::string sm2_text(const Sm2MissedStatus& status) {
  const auto missed = status.known ? status.missed : status.value;
  if (status.other_sub_index == 0) return fmt::format("{}", missed);
  return fmt::format("{}|{}", status.value, status.other_value);
}

Json sm2_other(const Sm2MissedStatus& status) {
  if (status.other_sub_index == 0) return nullptr;
  return {{"object", fmt::format("0x{:04X}:{:02X}", status.index, status.other_sub_index)},
          {"value", status.other_value}};
}

/// Of one that has no counter nothing is read: its misses are computed.
Json sm2_object(const Sm2MissedStatus& status) {
  if (status.sub_index == 0) return nullptr;
  return fmt::format("0x{:04X}:{:02X}", status.index, status.sub_index);
}

/// Since the slave was in OP first; its own counter where it has no SYNC0 that the master could follow.
Json sm2_missed(const RunReport::Slave& slave) {
  if (!slave.sm2_missed) return nullptr;
  return slave.sm2_missed->total();
}

Json slave_json(const RunReport::Slave& slave, Nanoseconds now) {
  return {{"position", slave.position},
          {"name", slave.name},
          {"state", state_text(slave.al_status)},
          {"al_status_code", hex(slave.al_status_code, 4)},
          {"al_status_age_ms", age_json(slave.al_status_time, now)},
          {"deviation_ns", or_null(slave.deviation_ns)},
          {"deviation_age_ms", age_json(slave.deviation_time, now)},
          {"deviation_max_ns", or_null(slave.deviation_max_ns)},
          {"sm2_missed", sm2_missed(slave)},
          {"sm2_object", slave.sm2_missed ? sm2_object(*slave.sm2_missed) : Json(nullptr)},
          {"sm2_integrator_max", slave.sm2_missed ? Json(slave.sm2_missed->integrator_highest) : Json(nullptr)},
          {"sm2_limit", slave.sm2_missed ? Json(slave.sm2_missed->limit) : Json(nullptr)},
          {"sm2_other", slave.sm2_missed ? sm2_other(*slave.sm2_missed) : Json(nullptr)},
          {"propagation_delay_ns", or_null(slave.propagation_delay_ns)},
          {"present", slave.present},
          {"evidence", evidence_json(slave, now)},
          {"deviation_mean_ns", slave.deviation.count() > 0 ? rounded(slave.deviation.mean()) : Json(nullptr)},
          {"deviation_mean_95_ns", interval_json(slave.deviation.mean_interval())}};
}

Json age_ms(Nanoseconds age) { return age < 0 ? Json(nullptr) : rounded(static_cast<double>(age) / 1e6); }

Json dc_json(const RunReport& report) {
  const auto& dc = report.dc;
  return {{"enabled", dc.enabled},
          {"reference_clock", dc.reference_clock < 0 ? Json(nullptr) : Json(dc.reference_clock)},
          {"monitored", dc.monitored},
          {"in_sync", or_null(slaves_in_sync(dc))},
          {"state", sync_state_key(dc.state)},
          {"state_for_ms", dc.enabled ? rounded(static_cast<double>(report.time - dc.since) / 1e6) : Json(nullptr)},
          {"newest_reading_age_ms", age_ms(dc.newest_age_ns)},
          {"oldest_reading_age_ms", age_ms(dc.oldest_age_ns)},
          {"followers", dc.followers},
          {"culprit", dc.culprit < 0 ? Json(nullptr) : Json(dc.culprit)},
          {"settled_after_ms", rounded(dc.settled_after_ms)},
          {"limit_ns", dc.monitored ? Json(dc.limit_ns) : Json(nullptr)},
          {"deviation_ns", {{"now", or_null(dc.deviation_ns)}, {"max", or_null(report.deviation_max_ns)}}}};
}

/// Errors count from the moment on at which the master was in sync: before it there are no figures of them.
bool has_error_figures(const DcmStatus& dcm) { return dcm.in_sync_after_ms.has_value(); }

Json dcm_json(const RunReport& report) {
  const auto& dcm = report.dcm;
  const auto figure = [&](auto value) { return has_error_figures(dcm) ? Json(value) : Json(nullptr); };
  return {{"mode", dcm_mode_name(dcm.mode)},
          {"in_sync", or_null(master_in_sync(dcm))},
          {"in_sync_after_ms", rounded(dcm.in_sync_after_ms)},
          {"state", sync_state_key(dcm.state)},
          {"obstacle", dcm.obstacle == dc::SyncObstacle::kNone || dcm.mode == DcmMode::kOff
                           ? Json(nullptr)
                           : Json(dc::obstacle_text(dcm.obstacle))},
          {"error_ns",
           {{"mean", figure(rounded(dcm.error_mean_ns))},
            {"rms", figure(rounded(dcm.error_rms_ns))},
            {"max", figure(dcm.error_max_ns)},
            {"mean_95", mean_interval(dcm.error_mean_ns, report.dcm_error)}}},
          {"external_error_ns", or_null(dcm.external_error_ns)},
          {"frame_error_ns", {{"now", dcm.frame_error_ns}, {"max", figure(dcm.frame_error_max_ns)}}},
          {"late_allowed_ns", dcm.late_allowed_ns},
          {"late_sends", figure(dcm.late_sends)},
          {"drift_ppm", rounded(dcm.drift_ppm)},
          {"error_code", dcm.error_code == 0 ? Json(nullptr) : Json(hex(dcm.error_code, 8))},
          {"set_value_ns", dcm.set_value_ns},
          {"adjust_permil", rounded(dcm.adjust_permil)},
          {"control_off", dcm.control_off},
          {"bus_shift_configured", dcm.bus_shift_configured},
          {"drift_95_ppm", drift_interval(dcm)}};
}

std::string or_dash(const std::optional<std::int32_t>& value) { return value ? fmt::format("{}", *value) : "-"; }

std::string ms_text(const std::optional<double>& ms) { return ms ? fmt::format("after {:.0f} ms", *ms) : "not yet"; }

}  // namespace

std::string state_text(std::uint16_t al_status) {
  const auto state = al_state_of(al_status);
  if (state == AlState::kNone) return "unknown";
  return std::string(al_state_name(state)) + ((al_status & kAlErrorFlag) != 0 ? "+ERR" : "");
}

Json to_json(const RunReport& report) {
  Json slaves = Json::array();
  for (const auto& slave : report.slaves) slaves.push_back(slave_json(slave, report.history.end));
  return {{"state", state_text(static_cast<std::uint16_t>(report.state))},
          {"cycle_us", rounded(static_cast<double>(report.cycle_time) / 1000.0)},
          {"cycles", report.cycles},
          {"slaves", slaves},
          {"dc", dc_json(report)},
          {"dcm", dcm_json(report)},
          {"wkc_errors", report.wkc_errors},
          {"lost_frames", report.lost_frames},
          {"late_frames", report.late_frames},
          {"overruns", report.overruns},
          {"skipped_cycles", report.skipped_cycles},
          {"findings", findings_json(report)}};
}

std::string to_text(const RunReport& report) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "state {}   {} of {} us   WKC errors {}   frames lost {}   late {}   cycles left out {}\n",
                 state_text(static_cast<std::uint16_t>(report.state)), counted(report.cycles, "cycle"),
                 static_cast<double>(report.cycle_time) / 1000.0, report.wkc_errors, report.lost_frames,
                 report.late_frames, report.skipped_cycles);
  fmt::format_to(out, "{:>3} {:<28} {:<10} {:>12} {:>14} {:>8} {:>12}\n", "POS", "NAME", "STATE", "DEVIATION ns",
                 "LARGEST ns", "SM2 MISS", "DELAY ns");
  for (const auto& slave : report.slaves) {
    fmt::format_to(out, "{:>3} {:<28} {:<10} {:>12} {:>14} {:>8} {:>12}\n", slave.position, slave.name,
                   slave.present ? state_text(slave.al_status) : "absent", or_dash(slave.deviation_ns),
                   or_dash(slave.deviation_max_ns), slave.sm2_missed ? sm2_text(*slave.sm2_missed) : "-",
                   slave.propagation_delay_ns ? fmt::format("{}", *slave.propagation_delay_ns) : "-");
  }
  const auto& dc = report.dc;
  fmt::format_to(out, "slaves: {}", dc.enabled ? sync_state_text(dc.state) : "no distributed clocks");
  if (dc.monitored) fmt::format_to(out, ", settled {}, limit {} ns", ms_text(dc.settled_after_ms), dc.limit_ns);
  if (report.deviation_max_ns) fmt::format_to(out, ", largest deviation {} ns", *report.deviation_max_ns);
  const auto& dcm = report.dcm;
  fmt::format_to(out, "\nmaster: {}, {}", dcm_mode_name(dcm.mode), sync_state_text(dcm.state));
  if (dcm.mode != DcmMode::kOff) {
    if (dcm.in_sync_after_ms) fmt::format_to(out, " {}", ms_text(dcm.in_sync_after_ms));
    if (has_error_figures(dcm))
      fmt::format_to(out, ", error mean {:.1f} ns, rms {:.1f} ns, largest {} ns (frames {} ns, {} allowed)",
                     dcm.error_mean_ns, dcm.error_rms_ns, dcm.error_max_ns, dcm.frame_error_max_ns,
                     dcm.late_allowed_ns);
    fmt::format_to(out, ", drift {:.3f} ppm{}", dcm.drift_ppm,
                   dcm.drift_half_width_ppm ? fmt::format(" ±{:.3f}", *dcm.drift_half_width_ppm) : "");
    if (dcm.external_error_ns) fmt::format_to(out, ", {:+} ns off the external clock", *dcm.external_error_ns);
    if (dcm.state == SyncState::kOutOfSync) fmt::format_to(out, " ({})", dc::obstacle_text(dcm.obstacle));
  }
  if (dcm.control_off)
    fmt::format_to(out, ", control is off: the timer would need {:+.4f} per mille", dcm.adjust_permil);
  if (dcm.error_code != 0) {
    fmt::format_to(out, "\nDCM error {} {}: {}", hex(dcm.error_code, 8), dc::dcm_error_name(dcm.error_code),
                   dc::dcm_error_text(dcm.error_code));
  }
  text += '\n';
  return text + findings_text(report);
}

bool is_good(const RunReport& report, AlState target) {
  const auto findings = diagnose(report);
  return report.state == target && is_synchronised(report.dc, report.dcm) &&
         std::ranges::none_of(findings, [](const Finding& finding) { return finding.severity == Severity::kError; });
}

}  // namespace syncline::cli
