// SPDX-License-Identifier: Apache-2.0
#include "app/cli/record_report.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/duration.h"
#include "app/cli/options.h"
#include "app/cli/record_range.h"
#include "eni/format/eni_file.h"
#include "eni/report/reported_eni.h"
#include "record/recorded_configuration.h"
#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "reports/acceptance.h"
#include "reports/commissioning_report.h"
#include "support/output_file.h"

namespace syncline::cli {
namespace {

struct ReportOptions {
  std::string file, out, machine, least_time;
  double least_margin_percent = 0;
  reports::AcceptanceLimits limits;
  bool json = false;
};

Json acceptance_json(const reports::Acceptance& acceptance) {
  Json criteria = Json::array();
  for (const auto& criterion : acceptance.criteria) {
    criteria.push_back({{"key", reports::criterion_key(criterion.kind)},
                        {"name", reports::criterion_text(criterion.kind)},
                        {"required", reports::required_text(criterion)},
                        {"found", reports::found_text(criterion)},
                        {"verdict", reports::verdict_key(criterion.verdict)}});
  }
  return {{"accepted", acceptance.verdict == reports::Verdict::kKept},
          {"verdict", reports::verdict_key(acceptance.verdict)},
          {"criteria", std::move(criteria)}};
}

std::string acceptance_lines(const reports::Acceptance& acceptance) {
  std::string text;
  for (const auto& criterion : acceptance.criteria) {
    text += fmt::format("{:<10}  {}: {} (required: {})\n", reports::verdict_text(criterion.verdict),
                        reports::criterion_text(criterion.kind), reports::found_text(criterion),
                        reports::required_text(criterion));
  }
  return text + fmt::format("{}\n", reports::acceptance_text(acceptance.verdict));
}

Status take_limits(ReportOptions& options) {
  options.limits.least_margin = options.least_margin_percent / 100;
  if (options.least_time.empty()) return {};
  const auto time = parse_duration(options.least_time);
  if (!time) return tl::unexpected(time.error());
  options.limits.least_time = *time;
  return {};
}

Result<reports::Acceptance> write_report(Context& context, const ReportOptions& options) {
  const auto distinct = CommandFiles().reads_recording("file", options.file).writes("out", options.out).check();
  if (!distinct) return tl::unexpected(distinct.error());
  auto reader = RecordingReader::open(options.file);
  if (!reader) return tl::unexpected(reader.error());
  auto info = reader->info();
  if (!info) return tl::unexpected(info.error());
  // Refused where it has no cycles.
  if (const auto whole = stretch_of({}, *info); !whole) return tl::unexpected(whole.error());
  auto config = recorded_configuration(info->about, eni::parse_eni);
  const auto run = replay_run(*reader, std::move(*info), std::move(config));
  if (!run) return tl::unexpected(run.error());
  warn_of_file(context, *reader);
  auto facts = reports::facts_of(*run, options.file);
  if (!options.machine.empty()) facts.machine = options.machine;
  facts.date = eni::report_date();
  facts.program = std::string("synclinectl ") + SYNCLINE_VERSION;
  const auto acceptance = reports::judge(*run->record, reports::severities_of(*run), options.limits);
  auto file = OutputFile::create(options.out);
  if (!file) return tl::unexpected(file.error());
  if (auto status = file->write(reports::commissioning_report(*run->record, facts, acceptance)); !status)
    return tl::unexpected(status.error());
  if (auto status = file->finish(); !status) return tl::unexpected(status.error());
  return acceptance;
}

void report(Context& context, ReportOptions& options) {
  if (const auto status = take_limits(options); !status) return context.fail_with(status.error());
  const auto acceptance = write_report(context, options);
  if (!acceptance) return context.fail_with(acceptance.error());
  if (acceptance->verdict != reports::Verdict::kKept) context.exit_code = kAnswerIsNo;
  if (options.json) return context.print(acceptance_json(*acceptance));
  context.console.out << acceptance_lines(*acceptance);
}

}  // namespace

void add_report_command(CLI::App& group, Context& context) {
  auto options = std::make_shared<ReportOptions>();
  auto* command = group.add_subcommand(
      "report", "Write the page that is handed over with a machine; exit code 1 where the run is not accepted");
  command->add_option("file", options->file, "Recording")->required();
  command->add_option("out", options->out, "HTML file to write")->required();
  command->add_option("--machine", options->machine, "Name of the machine; else the project's or the recording's file");
  command->add_option("--least-time", options->least_time, "It must have been watched for so long, e.g. 10min");
  command
      ->add_option("--least-margin", options->least_margin_percent,
                   "Part of its limit that the largest deviation must leave, %")
      ->check(CLI::Range(0.0, 100.0));
  command->add_option("--most-lost-frames", options->limits.most_lost_frames, "So many are accepted");
  command->add_option("--most-wkc-errors", options->limits.most_wkc_errors,
                      "The same of cycles with another working counter than expected");
  command->add_option("--most-left-out", options->limits.most_left_out,
                      "The same of cycles that the host was too late for");
  command->add_option("--most-missed-events", options->limits.most_missed_events, "The same of missed SM2 events");
  command->add_flag("--json", options->json, "Print the criteria as JSON");
  command->callback([&context, options] { report(context, *options); });
}

}  // namespace syncline::cli
