// SPDX-License-Identifier: Apache-2.0
#include "exports/export_report.h"

#include <fmt/format.h>

#include "exports/exports.h"
#include "exports/html_table.h"
#include "exports/report_sections.h"

namespace syncline::exports {
namespace {

// Classes begin with "r-": those of the drawing hold for the whole page.
constexpr const char* kPageStyle = R"(<style>
@page { size: A4; margin: 14mm; }
:root { color-scheme: light; }
body { font: 10pt/1.4 'Inter', 'Segoe UI', 'DejaVu Sans', sans-serif; color: #1f2933; background: #ffffff;
  max-width: 190mm; margin: 0 auto; padding: 8mm 4mm; }
h1 { font-size: 18pt; margin: 0 0 4mm; }
h2 { font-size: 13pt; margin: 8mm 0 2mm; border-bottom: 1px solid #9aa5b1; break-after: avoid; }
table { border-collapse: collapse; width: 100%; font-size: 8.5pt; margin: 2mm 0; }
th, td { text-align: left; vertical-align: top; padding: 1mm 2mm 1mm 0; border-bottom: 1px solid #e4e7eb;
  overflow-wrap: anywhere; }
thead { display: table-header-group; }
thead th { border-bottom: 1px solid #52606d; overflow-wrap: normal; }
tr { break-inside: avoid; }
table.facts th { width: 55mm; font-weight: 600; color: #52606d; }
tr.r-error td:first-child { color: #b42318; font-weight: 700; }
tr.r-warning td:first-child { color: #93590c; font-weight: 700; }
svg { max-width: 100%; height: auto; }
p { margin: 1mm 0; }
</style>
)";

/// The drawing without the head of a file of its own.
std::string drawing(const NetworkConfig& config) {
  const auto svg = topology_svg(config);
  return svg.substr(svg.find("<svg"));
}

std::string head(const NetworkConfig& config, const ReportFacts& facts) {
  HtmlTable table;
  table.row({"Project", facts.project});
  table.row({"Date", facts.date});
  table.row({"Program", facts.program});
  table.row({"ENI file", fmt::format("{}, {} bytes", facts.eni_file, facts.eni_bytes)});
  table.row({"Dialect", facts.dialect});
  table.row({"Master", config.master.name});
  table.row({"Slaves", std::to_string(config.slaves.size())});
  table.row({"Findings", finding_counts(facts.findings)});
  return table.end();
}

}  // namespace

std::string export_report(const NetworkConfig& config, const ReportFacts& facts) {
  const auto title = fmt::format("ENI of {}", facts.project);
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  out += html_element("title", title) + "\n" + kPageStyle + "</head>\n<body>\n" + html_element("h1", title) + "\n";
  out += head(config, facts);
  const auto section = [&out](std::string_view name, const std::string& content) {
    out += html_element("h2", name) + "\n" + content;
  };
  section("Slaves", slaves_section(config, facts.source));
  section("SYNC signals", sync_section(config, facts.source));
  section("Distributed clocks", clocks_section(config, facts.source != nullptr));
  section("Cyclic frames", frames_section(config));
  section("Findings", findings_section(facts.findings));
  section("Not in the ENI", unsaid_section(facts));
  section("Topology", drawing(config));
  return out + "</body>\n</html>\n";
}

}  // namespace syncline::exports
