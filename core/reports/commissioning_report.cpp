// SPDX-License-Identifier: Apache-2.0
#include "reports/commissioning_report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sha2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "channels/event_finding.h"
#include "exports/html_page.h"
#include "exports/html_table.h"
#include "exports/report_sections.h"
#include "record/replay_run.h"
#include "reports/acceptance.h"
#include "reports/run_pictures.h"
#include "trace/slave_figures.h"

namespace syncline::reports {
namespace {

using exports::html_element;
using exports::HtmlTable;

/// Seconds since the first sample, as findings count, too.
std::string moment(Nanoseconds time, Nanoseconds begin) {
  return fmt::format("{:.3f}", static_cast<double>(time - begin) / 1e9);
}

std::string utc(Nanoseconds time) {
  constexpr std::time_t kEpoch2000 = 946'684'800;
  return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(kEpoch2000 + static_cast<std::time_t>(time / kSecond)));
}

std::string paragraph(const std::string& text) { return html_element("p", text) + "\n"; }

std::string head(const RunRecord& run, const CommissioningFacts& facts, const Acceptance& acceptance) {
  const auto& overview = run.overview();
  HtmlTable table;
  table.row({"Result", std::string(acceptance_text(acceptance.verdict))}, acceptance.verdict == Verdict::kKept ? ""
                                                                          : acceptance.verdict == Verdict::kNotKept
                                                                              ? "r-error"
                                                                              : "r-warning");
  table.row({"Machine", facts.machine});
  table.row({"Watched", fmt::format("{} to {}", utc(overview.armed.value_or(overview.begin)), utc(overview.end)) +
                            (run.simulated() ? " by the clock of a simulated machine" : "")});
  table.row({"Recording", facts.recording.empty() ? "none: out of memory" : facts.recording});
  table.row({"Run by", facts.recorded_by.empty() ? "not told" : facts.recorded_by});
  table.row({"Link", facts.link.empty() ? "not told" : facts.link});
  table.row({"End", facts.ended ? *facts.ended : std::string("cut short, or it goes on")});
  for (const auto& document : facts.documents) {
    table.row(
        {document.kind == "project"    ? "Project"
         : document.kind == "triggers" ? "Triggers"
                                       : "Configuration",
         fmt::format("{}, {} bytes, SHA-256 {}", document.name, document.body.size(), sha256_text(document.body))});
  }
  table.row({"Report", fmt::format("{}, {}", facts.date, facts.program)});
  return table.end();
}

std::string criteria_section(const Acceptance& acceptance) {
  HtmlTable table({"Verdict", "Criterion", "Required", "Found"});
  for (const auto& criterion : acceptance.criteria) {
    table.row({std::string(verdict_text(criterion.verdict)), std::string(criterion_text(criterion.kind)),
               required_text(criterion), found_text(criterion)},
              criterion.verdict == Verdict::kNotKept ? "r-error" : "");
  }
  return table.end() + paragraph(
                           "Counted is what came since the run was armed: in OP, once all that is watched was in "
                           "sync. Bring-up is no part of it.");
}

/// With half of its 95 % interval where one can be stated, never narrower than it is.
std::string mean_text(const Statistics& statistics) {
  const auto text = fmt::format("{:.1f}", statistics.mean());
  const auto half = statistics.mean_half_width();
  return half ? text + fmt::format(" ± {:.1f}", std::ceil(*half * 10) / 10) : text;
}

void add_figure(HtmlTable& table, const std::string& name, const OverviewFigure& figure,
                const std::optional<double>& margin, std::int64_t limit, Nanoseconds begin) {
  const auto& statistics = figure.statistics;
  if (statistics.count() == 0) {
    table.row({name, "0", "", "", "", "", "", "no value"});
    return;
  }
  table.row({name, fmt::format("{}", statistics.count()), mean_text(statistics),
             fmt::format("{:.1f}", statistics.rms()), fmt::format("{}", figure.magnitudes.percentile(0.9999)),
             fmt::format("{}", std::abs(figure.largest->value)), moment(figure.largest->time, begin),
             !margin       ? "no limit"
             : *margin < 0 ? fmt::format("over ±{} ns", limit)
                           : fmt::format("{:.0f} % to ±{} ns", std::floor(*margin * 100), limit)});
}

std::string figures_section(const RunRecord& run) {
  const auto& overview = run.overview();
  HtmlTable table({"Figure", "Values", "Mean, ns", "Rms, ns", "99.99 %, ns", "Largest, ns", "At, s", "Margin"});
  const auto& limits = run.limits();
  add_figure(table, "Deviation of the slaves (0x092C), largest in each cycle", overview.deviation,
             overview.deviation.margin(limits.deviation_ns), limits.deviation_ns, overview.begin);
  add_figure(table, "Error of the master synchronisation", overview.dcm_error, {}, 0, overview.begin);
  add_figure(table, "The same, filtered", overview.dcm_filtered, overview.dcm_lasting.margin(limits.dcm_error_ns),
             limits.dcm_error_ns, overview.begin);
  return table.end() +
         paragraph(
             "A mean has half of its 95 % interval behind it, where the values are enough to say so. The margin of the "
             "filtered error is that of what has lasted for 200 ms: what is over before is no loss of "
             "synchronisation.");
}

struct Stretch {
  Nanoseconds begin = 0, end = 0;
};

/// What of the watched time is still kept cycle by cycle.
Stretch kept_of(const RunRecord& run) {
  const auto& overview = run.overview();
  if (run.samples().empty()) return {};
  return {std::max(overview.armed.value_or(overview.begin), run.samples().first_time()), overview.end};
}

std::string kept_words(const RunRecord& run) {
  const auto& overview = run.overview();
  const auto kept = kept_of(run);
  if (kept.begin <= overview.armed.value_or(overview.begin)) return {};
  return paragraph(
      fmt::format("Of the time that was watched the latest {:.3f} s are kept cycle by cycle: these are shown.",
                  static_cast<double>(kept.end - kept.begin) / 1e9));
}

std::string pictures_section(const RunRecord& run) {
  const auto kept = kept_of(run);
  const auto& samples = run.samples();
  const auto& overview = run.overview();
  std::string out = kept_words(run);
  const auto add = [&](const char* title, Signal signal, double limit, bool is_signed, const OverviewFigure& figure) {
    const auto course = course_svg({samples.series(signal), kept.begin, kept.end, limit, is_signed});
    if (course.empty()) return;
    out += paragraph(fmt::format("{} over time since {} s, and how often which magnitude came:", title,
                                 fmt::format("{:.3f}", static_cast<double>(kept.begin - overview.begin) / 1e9))) +
           course + histogram_svg(figure.magnitudes, limit);
  };
  add("Deviation of the slaves", Signal::kDeviation, run.limits().deviation_ns, false, overview.deviation);
  add("Error of the master synchronisation", Signal::kDcmErrorFiltered, static_cast<double>(run.limits().dcm_error_ns),
      true, overview.dcm_filtered);
  return out.empty() ? paragraph("There is no value to be drawn.") : out;
}

std::string slaves_section(const RunRecord& run) {
  const auto kept = kept_of(run);
  const double limit = run.limits().deviation_ns;
  SlaveFigureRound round;
  round.aim(run.samples(), kept.begin, kept.end + 1, limit);
  while (!round.work(1U << 20)) {
  }
  const auto& figures = round.figures();
  std::size_t worst = figures.size();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (figures[i].statistics.count() == 0) continue;
    if (worst == figures.size() || figures[i].statistics.max_magnitude() > figures[worst].statistics.max_magnitude())
      worst = i;
  }
  const auto& missed = run.overview().missed;
  HtmlTable table({"Pos.", "Name", "Readings", "Mean, ns", "Rms, ns", "Largest, ns", "Margin", "SM2 events missed"});
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto& statistics = figures[i].statistics;
    const bool read = statistics.count() > 0;
    const auto number = [&](double value) { return read ? fmt::format("{:.1f}", value) : std::string("-"); };
    std::string margin = "-";
    if (read && limit > 0) {
      const double left = 1 - statistics.max_magnitude() / limit;
      margin = left < 0 ? "over the limit" : fmt::format("{:.0f} %", std::floor(left * 100));
    }
    const bool counted = figures[i].missed.has_value();
    table.row({std::to_string(i), run.slave_name(i) + (i == worst ? " (largest)" : ""),
               fmt::format("{}", statistics.count()), read ? mean_text(statistics) : "-", number(statistics.rms()),
               read ? fmt::format("{:.0f}", statistics.max_magnitude()) : "-", margin,
               counted && i < missed.by_slave.size() ? fmt::format("{}", missed.by_slave[i]) : "-"});
  }
  return kept_words(run) + table.end() +
         paragraph(
             "Register 0x092C, read one slave after the other. A dash: no clock that follows the reference clock, "
             "or no such counter.");
}

std::string fault_text(const Fault& fault) {
  if (!fault.event) return fmt::format("{} SM2 events missed", fault.count);
  const auto finding = event_finding(*fault.event);
  const auto text = finding ? describe(*finding) : std::string("an event");
  return fault.count > 1 ? text + fmt::format(" ({} times)", fault.count) : text;
}

std::string faults_section(const RunRecord& run) {
  const auto& overview = run.overview();
  const auto& faults = overview.faults;
  if (faults.count() == 0) return paragraph("Nothing went wrong while it was watched.");
  HtmlTable table({"At, s", "Behind the first, ms", "Slave", "What"});
  for (const auto& episode : faults.episodes()) {
    for (const auto& fault : episode.faults) {
      const bool first = &fault == &episode.faults.front();
      table.row(
          {moment(fault.first, overview.begin),
           first ? "first" : fmt::format("{:.3f}", static_cast<double>(fault.first - episode.begin) / 1e6),
           fault.slave < 0 ? "network" : run.slave_name(static_cast<std::size_t>(fault.slave)), fault_text(fault)},
          first ? "r-error" : "");
    }
    if (episode.left_out > 0) table.row({"", "", "", fmt::format("and {} more", episode.left_out)});
  }
  std::string out = table.end();
  if (faults.count() > faults.episodes().size()) {
    out += paragraph(fmt::format("{} earlier episodes are not listed.", faults.count() - faults.episodes().size()));
  }
  return out;
}

std::string found_section(const RunRecord& run, const CommissioningFacts& facts) {
  if (!facts.told.empty()) {
    HtmlTable table({"Severity", "Where", "Code", "Finding"});
    for (const auto& finding : facts.told) {
      table.row({finding.level, finding.slave < 0 ? "network" : fmt::format("slave {}", finding.slave), finding.code,
                 finding.text},
                "r-" + finding.level);
    }
    return table.end();
  }
  const auto findings = run.findings();
  return findings.empty() ? paragraph("Nothing was found.") : exports::findings_section(findings);
}

std::string notes_section(const RunRecord& run) {
  if (run.notes().empty()) return paragraph("None.");
  HtmlTable table({"At, s", "Note"});
  for (const auto& note : run.notes()) table.row({moment(note.time, run.overview().begin), note.text});
  return table.end();
}

}  // namespace

CommissioningFacts facts_of(const RecordingAbout& about, const std::string& path) {
  CommissioningFacts facts;
  const std::filesystem::path file(path);
  const auto project = std::ranges::find(about.documents, "project", &RecordedDocument::kind);
  facts.machine =
      project != about.documents.end() ? std::filesystem::path(project->name).stem().string() : file.stem().string();
  facts.recording = file.filename().string();
  facts.recorded_by = about.program;
  facts.link = about.link;
  facts.documents = about.documents;
  return facts;
}

CommissioningFacts facts_of(const ReplayedRun& run, const std::string& path) {
  auto facts = facts_of(run.info.about, path);
  facts.ended = run.info.ended;
  if (run.only_words) facts.told = run.info.findings;
  return facts;
}

std::vector<Finding> severities_of(const ReplayedRun& run) {
  if (!run.only_words) return run.record->findings();
  std::vector<Finding> findings;
  for (const auto& told : run.info.findings) {
    auto& finding = findings.emplace_back();
    for (const auto severity : {Severity::kNote, Severity::kWarning, Severity::kError}) {
      if (told.level == severity_name(severity)) finding.severity = severity;
    }
  }
  return findings;
}

std::string sha256_text(std::string_view bytes) {
  SHA2_CTX context;
  SHA256Init(&context);
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest{};
  SHA256Final(digest.data(), &context);
  std::string text;
  for (const auto byte : digest) text += fmt::format("{:02x}", byte);
  return text;
}

std::string commissioning_report(const RunRecord& run, const CommissioningFacts& facts, const Acceptance& acceptance) {
  const auto& config = run.config();
  return exports::HtmlPage(fmt::format("Commissioning of {}", facts.machine), head(run, facts, acceptance))
      .section("Criteria", criteria_section(acceptance))
      .section("Synchronisation", figures_section(run))
      .section("Course and distribution", pictures_section(run))
      .section("Slaves", slaves_section(run))
      .section("Disturbances", faults_section(run))
      .section("Findings", found_section(run, facts))
      .section("Notes", notes_section(run))
      .section("SYNC signals", exports::sync_section(config, nullptr))
      .section("Topology", exports::topology_section(config))
      .end();
}

}  // namespace syncline::reports
