// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "app/cli/context.h"
#include "app/cli/findings_text.h"
#include "app/cli/options.h"
#include "app/cli/terminal_reason.h"
#include "check/check_network.h"
#include "eni/check/eni_check.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

struct CheckOptions {
  std::string file, severity = "note";
  bool strict = false, rules = false, json = false;
};

Severity severity_of(const std::string& name) {
  for (const auto severity : {Severity::kError, Severity::kWarning}) {
    if (name == severity_name(severity)) return severity;
  }
  return Severity::kNote;
}

Json rule_json(const FindingWords& rule) {
  return {{"code", rule.code},
          {"severity", severity_name(rule.severity)},
          {"title", rule.title},
          {"why", rule.why},
          {"mend", rule.mend}};
}

Json checked_json(const eni::EniCheck& check, const Finding& finding) {
  const FindingWords& rule = *find_finding_words(finding.code);
  const Place& place = finding.place;
  return {{"code", finding.code},
          {"severity", severity_name(finding.severity)},
          {"line", place.line},
          {"path", place.path},
          {"slave", place.slave < 0 ? Json() : Json(place.slave)},
          {"slave_name", place.slave < 0 ? Json() : Json(check.slave_name(finding))},
          {"what", facts_text(finding)},
          {"title", rule.title},
          {"why", rule.why},
          {"mend", rule.mend},
          {"key", place.key.empty() ? Json() : Json(place.key)},
          {"evidence", figures_json(finding)}};
}

/// Why and how stand once a rule: a mistake in a hundred slaves is one mistake to understand.
void print_check(std::ostream& out, const std::string& file, const eni::EniCheck& check) {
  std::set<std::string_view> explained;
  for (const auto& finding : check.findings) {
    const FindingWords& rule = *find_finding_words(finding.code);
    const Place& place = finding.place;
    const std::string line = place.line > 0 ? fmt::format("{}:{}", file, place.line) : file;
    const std::string slave =
        place.slave < 0 ? "" : fmt::format(" slave {} ({}):", place.slave, check.slave_name(finding));
    out << fmt::format("{}: {}:{} {} [{}]\n", line, severity_name(finding.severity), slave, facts_text(finding),
                       finding.code);
    if (!explained.insert(finding.code).second) continue;
    if (!place.path.empty()) out << fmt::format("    at   {}\n", place.path);
    out << fmt::format("    rule {}\n    why  {}\n    mend {}\n", rule.title, rule.why, rule.mend);
  }
}

void print_rules(Context& context, bool json) {
  if (json) {
    Json rows = Json::array();
    for (const FindingWords& rule : check_rules()) rows.push_back(rule_json(rule));
    return context.print({{"rules", rows}});
  }
  for (const FindingWords& rule : check_rules()) {
    context.console.out << fmt::format("{:<12} {:<7} {}\n", rule.code, severity_name(rule.severity), rule.title);
  }
}

void check(Context& context, const CheckOptions& options) {
  if (options.rules) return print_rules(context, options.json);
  if (options.file.empty()) {
    return context.fail_with(
        Error{.code = ErrorCode::kBadValue, .subject = "FILE", .detail = in_terminal("name an ENI file, or --rules")});
  }
  auto checked = eni::check_eni(options.file);
  if (!checked) return context.fail_with(checked.error());
  auto& findings = checked->findings;
  const std::size_t errors = checked->count(Severity::kError);
  const std::size_t warnings = checked->count(Severity::kWarning);
  const std::size_t notes = checked->count(Severity::kNote);
  if (errors > 0 || (options.strict && warnings > 0)) context.exit_code = kAnswerIsNo;
  std::erase_if(findings, [&](const auto& finding) { return finding.severity < severity_of(options.severity); });
  if (options.json) {
    Json rows = Json::array();
    for (const auto& finding : findings) rows.push_back(checked_json(*checked, finding));
    return context.print({{"file", options.file},
                          {"understood", checked->understood},
                          {"slaves", checked->slaves.size()},
                          {"errors", errors},
                          {"warnings", warnings},
                          {"notes", notes},
                          {"not_listed", checked->not_listed.all()},
                          {"findings", rows}});
  }
  print_check(context.console.out, options.file, *checked);
  if (!checked->understood) {
    context.console.out << options.file
                        << ": only the structure was checked; mend the errors above, then check again\n";
  }
  context.console.out << fmt::format("{}, {}, {}\n", counted(errors, "error"), counted(warnings, "warning"),
                                     counted(notes, "note"));
}

}  // namespace

void add_check_command(CLI::App& app, Context& context) {
  auto* command =
      app.add_subcommand("check", "Check an ENI file: structure, references, commands, clocks, process image");
  auto options = std::make_shared<CheckOptions>();
  auto* file = command->add_option("file", options->file, "ENI file");
  auto* severity = command->add_option("--severity", options->severity, "Lowest severity shown: note, warning or error")
                       ->check(CLI::IsMember({"note", "warning", "error"}));
  auto* strict = command->add_flag("--strict", options->strict, "Warnings count as errors for the exit code");
  command->add_flag("--rules", options->rules, "List the rules instead")
      ->excludes(file)
      ->excludes(severity)
      ->excludes(strict);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { check(context, *options); });
}

}  // namespace syncline::cli
