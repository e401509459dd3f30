// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/findings_text.h"
#include "app/cli/options.h"
#include "app/composition/load_config.h"
#include "eni/check/eni_check.h"
#include "eni/format/eni_file.h"
#include "eni/report/reported_eni.h"
#include "eni/xml/xml_text.h"
#include "exports/formats.h"
#include "findings/recovered_words.h"
#include "findings/sentence.h"
#include "recover/recover_project.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

struct ExportOptions {
  std::string file, network, output, dialect, report, format = "eni";
  bool json = false;
};

EniDialect chosen_dialect(const ExportOptions& options) {
  return options.dialect == "twincat" ? EniDialect::kTwinCat : EniDialect::kEcEngineer;
}

std::string content(const ExportOptions& options, const NetworkConfig& config) {
  if (const auto* format = exports::find_format(options.format))
    return format->text(config, std::filesystem::path(options.output).stem().string());
  return eni::write_eni(config, eni::style_of(chosen_dialect(options)));
}

/// An ENI that is exported again keeps its commands, and with them the layout of its image.
std::vector<Finding> about_layout(const ExportOptions& options, const LoadedConfig& loaded) {
  if (!loaded.is_eni || options.dialect.empty() || dialect_of(loaded.config) == chosen_dialect(options)) return {};
  return {make_finding<words::kRecovered>("eni-layout-kept", {}, fig::text<"file">(options.file))};
}

Status write(const ExportOptions& options, const LoadedConfig& loaded) {
  if (options.report.empty()) return eni::write_file_atomic(options.output, content(options, loaded.config));
  const eni::ReportedEni reported{.config = loaded.config,
                                  .dialect = chosen_dialect(options),
                                  .source = loaded.source ? &*loaded.source : nullptr,
                                  .name = std::filesystem::path(options.file).filename().string(),
                                  .program = std::string("synclinectl ") + SYNCLINE_VERSION,
                                  .date = eni::report_date(),
                                  .findings = loaded.findings};
  return eni::save_reported_eni(reported, options.output, options.report);
}

/// Of an ENI that is exported again `check` tells, whoever wrote it.
std::vector<Finding> wrong_in_export(const ExportOptions& options, const LoadedConfig& loaded) {
  if (loaded.is_eni || options.format != "eni") return {};
  return eni::errors_of_export(content(options, loaded.config));
}

void export_file(Context& context, const ExportOptions& options) {
  if (!options.report.empty() && options.format != "eni")
    return context.fail_with_words("--report goes with an ENI, not with --format " + options.format, kUsage);
  const auto distinct = CommandFiles()
                            .reads("file", options.file)
                            .writes("--output", options.output)
                            .writes("--report", options.report)
                            .check();
  if (!distinct) return context.fail_with(distinct.error());
  auto loaded = load_any_config(options.file, {chosen_dialect(options)}, options.network);
  if (!loaded) return context.fail_with(loaded.error());
  for (auto& finding : about_layout(options, *loaded)) loaded->findings.push_back(std::move(finding));
  const bool refused = has_errors(loaded->findings);
  if (!refused) {
    if (const auto status = write(options, *loaded); !status) return context.fail_with(status.error());
    for (auto& finding : wrong_in_export(options, *loaded)) loaded->findings.push_back(std::move(finding));
  }
  const bool wrong = has_errors(loaded->findings);
  if (wrong) context.exit_code = kAnswerIsNo;
  const auto slaves = loaded->config.slaves.size();
  if (options.json) {
    return context.print({{"file", options.output},
                          {"written", !refused},
                          {"slaves", slaves},
                          {"findings", to_json(loaded->findings)},
                          {"format", options.format},
                          {"report", options.report.empty() ? Json(nullptr) : Json(options.report)}});
  }
  print(context.console.err, loaded->findings);
  if (refused) {
    context.console.err << "synclinectl: " << options.output << " was not written; mend the errors above first\n";
  } else {
    context.console.out << fmt::format("{}: {}\n", options.output, counted(slaves, "slave"));
    if (!options.report.empty()) context.console.out << fmt::format("{}: report\n", options.report);
    if (wrong)
      context.console.err << fmt::format("synclinectl: {} was written; masters may refuse it for the errors above\n",
                                         options.output);
  }
}

}  // namespace

void add_export_command(CLI::App& app, Context& context) {
  auto* command =
      app.add_subcommand("export", "Write the ENI file of a project or of an ENI, or tables, a C header, a drawing");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("file", options->file, "Project or ENI file")->required();
  command->add_option("-o,--output", options->output, "File to write")->required();
  std::vector<std::string> names{"eni"};
  std::string about = "eni";
  for (const auto& format : exports::formats()) {
    names.emplace_back(format.name);
    about += fmt::format(", {} ({})", format.name, format.what);
  }
  command->add_option("--format", options->format, about)->check(CLI::IsMember(names));
  command->add_option("--dialect", options->dialect, "ec-master or twincat")
      ->check(CLI::IsMember({"ec-master", "twincat"}));
  command->add_option("--report", options->report,
                      "HTML file that documents the ENI: slaves, clocks, frames, findings, drawing");
  command->add_option("--network", options->network, "Network of a file that holds several: name or number");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { export_file(context, *options); });
}

}  // namespace syncline::cli
