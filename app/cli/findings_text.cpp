// SPDX-License-Identifier: Apache-2.0
#include "app/cli/findings_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace syncline::cli {
namespace {

std::string_view severity_name(FindingSeverity severity) {
  switch (severity) {
    case FindingSeverity::kInfo:
      return "note";
    case FindingSeverity::kWarning:
      return "warning";
    case FindingSeverity::kError:
      return "error";
  }
  return "note";
}

}  // namespace

bool has_errors(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity == FindingSeverity::kError; });
}

Json to_json(const std::vector<Finding>& findings) {
  Json rows = Json::array();
  for (const auto& finding : findings) {
    rows.push_back({{"severity", severity_name(finding.severity)},
                    {"slave", finding.slave},
                    {"key", finding.key},
                    {"text", finding.text}});
  }
  return rows;
}

void print(std::ostream& out, const std::vector<Finding>& findings) {
  for (const auto& finding : findings) {
    const auto place = finding.slave < 0 ? std::string("master") : fmt::format("slave {}", finding.slave);
    out << fmt::format("{}: {}: {}{}\n", severity_name(finding.severity), place, finding.text,
                       finding.key.empty() ? "" : " [" + finding.key + "]");
  }
}

}  // namespace syncline::cli
