// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"
#include "protocol/port_damage.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {
namespace {

/// A hot-connect group may be away as a whole.
bool is_absent(const RunReport& report, std::size_t position) {
  const auto& slave = report.slaves[position];
  if (slave.present || !slave.optional) return !slave.present;
  return slave.group_head != slave.position && report.slaves[static_cast<std::size_t>(slave.group_head)].present;
}

Figure slaves_figure(std::size_t first, std::size_t last) {
  return {"slaves", Figure::Unit::kSlave, static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}

/// Behind the one it is wired to; those that are absent with it are the same case.
Finding absent(const RunReport& report, std::size_t first, std::size_t last) {
  const auto& history = report.history.slaves[first];
  const auto since = history.absences.first() == 0 ? report.history.begin : history.absences.last();
  Finding finding{code::kSlaveAbsent, Severity::kError, static_cast<int>(first), since, report.history.end};
  finding.figures = {slaves_figure(first, last),
                     moment_figure(report, "since", since),
                     {"near", Figure::Unit::kSlave, report.slaves[first].parent, report.slaves[first].parent}};
  if (history.cable) {
    finding.code = code::kSlaveAbsentBehindCable;
    finding.figures.back().value = finding.figures.back().other = history.cable->near;
    finding.figures.push_back({"port", Figure::Unit::kPort, history.cable->port});
  }
  return finding;
}

/// Every frame was damaged on its way: that is told with the port, and nobody was away. A plug that is pulled may
/// damage frames, too, and loses the link.
bool was_noise(const RunReport& report, const Spell& spell) {
  return was_silence_of_all(report, spell) && noisy_port(report, spell).slave >= 0;
}

void find_earlier(const RunReport& report, Findings& findings) {
  for (std::size_t i = 0; i < report.slaves.size(); ++i) {
    const auto& absences = report.history.slaves[i].absences;
    const auto explained = [&](const Spell& spell) {
      return adapter_was_away(report, spell) || was_noise(report, spell) || was_seeming(report, spell);
    };
    if (!absences.empty() && std::ranges::all_of(absences.list(), explained)) continue;
    if (absences.empty() || is_absent(report, i) || report.slaves[i].optional) continue;
    std::size_t last = i;
    const auto same = [&](std::size_t next) {
      const auto& others = report.history.slaves[next].absences;
      return !is_absent(report, next) && others.count() == absences.count() &&
             others.near(absences.list().front(), kTogether);
    };
    while (last + 1 < report.slaves.size() && same(last + 1)) ++last;
    const auto& first = absences.list().front();
    findings.push_back({code::kSlaveWasAbsent,
                        Severity::kWarning,
                        static_cast<int>(i),
                        first.from,
                        absences.last(),
                        {slaves_figure(i, last), moment_figure(report, "since", first.from),
                         time_figure("length", first.to - first.from), times_figure("count", absences.count())}});
    i = last;
  }
}

}  // namespace

void find_link_outages(const RunReport& report, Findings& findings) {
  const auto& outages = report.history.link_outages;
  if (outages.empty()) return;
  const auto& first = outages.list().front();
  Finding finding{code::kAdapterWasAway, Severity::kWarning, -1, first.from, outages.last()};
  finding.figures = {text_figure("adapter", report.history.link), moment_figure(report, "since", first.from),
                     time_figure("length", first.to - first.from), times_figure("count", outages.count())};
  if (report.history.link_down) {
    finding.code = code::kAdapterAway;
    finding.severity = Severity::kError;
    finding.from = outages.last();
    finding.figures[1] = moment_figure(report, "since", outages.last());
  }
  findings.push_back(std::move(finding));
}

void find_absent_slaves(const RunReport& report, Findings& findings) {
  for (std::size_t i = 0; i < report.slaves.size(); ++i) {
    if (!is_absent(report, i) || report.history.link_down) continue;
    // Of a bus that was never operated nobody knows: the error of its bring-up says why.
    if (report.cycles == 0 && report.history.slaves[i].absences.empty()) continue;
    std::size_t last = i;
    while (last + 1 < report.slaves.size() && is_absent(report, last + 1)) ++last;
    findings.push_back(absent(report, i, last));
    i = last;
  }
  find_earlier(report, findings);
}

}  // namespace syncline::diagnosis
