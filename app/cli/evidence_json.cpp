// SPDX-License-Identifier: Apache-2.0
#include "app/cli/evidence_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/cli/findings_text.h"
#include "app/cli/milliseconds.h"
#include "diagnosis/run_diagnosis.h"
#include "findings/fold.h"

namespace syncline::cli {
namespace {

Json moment_json(const RunReport& report, Nanoseconds time) {
  if (time == 0) return nullptr;
  return milliseconds(time - report.history.begin);
}

Json count_json(const EvidenceCount& count, Nanoseconds now) {
  if (!count.valid()) return nullptr;
  return {{"count", count.total}, {"at_least", count.at_least}, {"age_ms", age_json(count.time, now)}};
}

Json ports_json(const SlaveEvidence& evidence) {
  Json ports = Json::array();
  for (const auto& port : evidence.ports) {
    ports.push_back({{"invalid_frames", port.invalid_frames},
                     {"receive_errors", port.receive_errors},
                     {"forwarded_errors", port.forwarded_errors},
                     {"lost_links", port.lost_links},
                     {"at_least", port.at_least}});
  }
  return ports;
}

Json sync0_json(const Sync0Start& start, Nanoseconds now) {
  if (start.time == 0) return nullptr;
  return {{"never_comes", start.never},
          {"off_ns", start.never ? Json(nullptr) : Json(start.off_ns)},
          {"age_ms", age_json(start.time, now)}};
}

Json misses_json(const RunReport::Slave& slave, Nanoseconds now) {
  if (!slave.sm2_missed || !slave.sm2_missed->known) return nullptr;
  const auto& status = *slave.sm2_missed;
  const auto of = [&status](dc::MissCause cause) { return status.by_cause[static_cast<std::size_t>(cause)]; };
  return {{"missed", status.missed},
          {"computed", status.computed},
          {"at_least", status.at_least},
          {"counter", status.valid ? Json(status.value) : Json(nullptr)},
          {"age_ms", age_json(status.time, now)},
          {"by_cause",
           {{"frame_lost", of(dc::MissCause::kFrameLost)},
            {"cycles_left_out", of(dc::MissCause::kCyclesLeftOut)},
            {"frame_held_up", of(dc::MissCause::kFrameHeldUp)},
            {"frame_late", of(dc::MissCause::kFrameLate)},
            {"unknown", of(dc::MissCause::kUnknown)}}}};
}

}  // namespace

/// What was read behind the newest cycle is of this moment.
Json age_json(Nanoseconds time, Nanoseconds now) {
  return time == 0 ? Json(nullptr) : Json(milliseconds(std::max<Nanoseconds>(0, now - time)));
}

Json findings_json(const RunReport& report) {
  Json rows = Json::array();
  for (const auto& finding : diagnose(report)) {
    rows.push_back({{"code", finding.code},
                    {"severity", severity_name(finding.severity)},
                    {"slave", finding.place.slave < 0 ? Json(nullptr) : Json(finding.place.slave)},
                    {"from_ms", moment_json(report, finding.from)},
                    {"to_ms", moment_json(report, finding.to)},
                    {"evidence", figures_json(finding)},
                    {"text", describe(finding)},
                    {"place", place_json(finding.place)}});
  }
  return rows;
}

std::string findings_text(const RunReport& report) {
  std::string text;
  for (const auto& [finding, slaves] : folded(diagnose(report))) {
    fmt::format_to(std::back_inserter(text), "{}: {}\n", severity_name(finding.severity), describe(finding));
  }
  return text;
}

Json evidence_json(const RunReport::Slave& slave, Nanoseconds now) {
  const auto& e = slave.evidence;
  return {{"sm2_events", misses_json(slave, now)},
          {"outputs_cycle_exceeded", count_json(e.outputs.exceeded, now)},
          {"outputs_shift_too_short", count_json(e.outputs.shift_too_short, now)},
          {"sync_error", e.outputs.sync_error},
          {"sync_error_age_ms", age_json(e.outputs.sync_error_time, now)},
          {"inputs_cycle_exceeded", count_json(e.inputs.exceeded, now)},
          {"inputs_shift_too_short", count_json(e.inputs.shift_too_short, now)},
          {"sync0_start", sync0_json(e.sync0, now)},
          {"process_data_watchdog", count_json(e.process_data_watchdog, now)},
          {"pdi_watchdog", count_json(e.pdi_watchdog, now)},
          {"processing_unit_errors", count_json(e.processing_unit_errors, now)},
          {"pdi_errors", count_json(e.pdi_errors, now)},
          {"speed_counter_difference", e.speed_counter_time == 0 ? Json(nullptr) : Json(e.speed_counter_difference)},
          {"speed_counter_age_ms", age_json(e.speed_counter_time, now)},
          {"ports", e.ports_time == 0 ? Json(nullptr) : ports_json(e)},
          {"ports_age_ms", age_json(e.ports_time, now)}};
}

}  // namespace syncline::cli
