// SPDX-License-Identifier: Apache-2.0
#include "exports/export_report.h"

#include <fmt/format.h>

#include "config/network_config.h"
#include "exports/html_page.h"
#include "exports/html_table.h"
#include "exports/report_sections.h"

namespace syncline::exports {
namespace {

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
  return HtmlPage(fmt::format("ENI of {}", facts.project), head(config, facts))
      .section("Slaves", slaves_section(config, facts.source))
      .section("SYNC signals", sync_section(config, facts.source))
      .section("Distributed clocks", clocks_section(config, facts.source != nullptr))
      .section("Cyclic frames", frames_section(config))
      .section("Findings", findings_section(facts.findings))
      .section("Not in the ENI", unsaid_section(facts))
      .section("Topology", topology_section(config))
      .end();
}

}  // namespace syncline::exports
