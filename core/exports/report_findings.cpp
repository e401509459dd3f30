// SPDX-License-Identifier: Apache-2.0
// What the report says of findings, and of what the ENI cannot say.
#include <fmt/format.h>

#include <algorithm>

#include "exports/export_report.h"
#include "exports/html_table.h"
#include "exports/report_sections.h"
#include "findings/fold.h"
#include "support/counted.h"

namespace syncline::exports {
namespace {

std::string place_of(const FoldedFinding& folded) {
  const auto& place = folded.finding.place;
  std::string text = place.slave < 0            ? std::string("network")
                     : folded.slaves.size() > 1 ? "slaves " + ranges_text(folded.slaves)
                                                : fmt::format("slave {}", place.slave);
  if (place.line > 0) text += fmt::format(", line {}", place.line);
  return text;
}

}  // namespace

std::string finding_counts(std::span<const Finding> findings) {
  std::string text;
  for (const auto severity : {Severity::kError, Severity::kWarning, Severity::kNote}) {
    const auto count = std::ranges::count(findings, severity, &Finding::severity);
    if (count > 0) text += (text.empty() ? "" : ", ") + counted(count, severity_name(severity));
  }
  return text.empty() ? "none" : text;
}

std::string findings_section(std::span<const Finding> findings) {
  if (findings.empty()) return html_element("p", "The check finds nothing.") + "\n";
  HtmlTable table({"Severity", "Where", "Code", "Finding"});
  for (const auto severity : {Severity::kError, Severity::kWarning, Severity::kNote}) {
    for (const auto& entry : folded(findings)) {
      if (entry.finding.severity != severity) continue;
      const auto name = std::string(severity_name(severity));
      table.row({name, place_of(entry), std::string(entry.finding.code), describe(entry.finding)}, "r-" + name);
    }
  }
  return table.end();
}

std::string unsaid_section(const ReportFacts& facts) {
  if (facts.source == nullptr) {
    return html_element("p", "What the project behind this ENI sets beyond it is not known: it was read from an ENI.") +
           "\n";
  }
  HtmlTable table({"Setting", "Value", "Key"});
  for (const auto& setting : facts.unsaid) table.row({setting.label, setting.value, setting.key});
  return html_element("p",
                      fmt::format("The dialect {} of ENI files has no place for these settings, or says only a part "
                                  "of them: set them in the master that runs the file.",
                                  facts.dialect)) +
         "\n" + table.end();
}

}  // namespace syncline::exports
