// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/cli/esi_command.h"
#include "app/cli/esi_folders.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/catalogue/usual_sources.h"
#include "eni/xml/file_warning.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

struct IndexOptions {
  std::vector<std::string> folders;
  std::string cache;
  bool forget = false, progress = false, json = false;
};

Json report_json(const std::string& folder, const eni::IndexReport& report) {
  return {{"folder", folder},
          {"files", report.files},
          {"read", report.read},
          {"touched", report.touched},
          {"removed", report.removed},
          {"cancelled", report.cancelled},
          {"unreadable", report.unreadable}};
}

std::string report_line(const std::string& folder, const eni::IndexReport& report) {
  return fmt::format("{}: {}, {} read, {} unchanged, {} removed{}\n", folder, counted(report.files, "file"),
                     report.read, report.files - report.read, report.removed, report.cancelled ? ", cancelled" : "");
}

Json duplicate_json(const eni::DuplicateDevice& duplicate) {
  Json entries = Json::array();
  for (const auto& entry : duplicate.entries) entries.push_back({{"file", entry.file}, {"line", entry.line}});
  return {{"identity", to_string(duplicate.identity)}, {"conflict", duplicate.conflict}, {"entries", entries}};
}

void print_index(Context& context, const eni::EsiCatalogue& catalogue,
                 const std::vector<eni::DuplicateDevice>& duplicates) {
  auto& out = context.console.out;
  std::size_t harmless = 0;
  for (const auto& duplicate : duplicates) {
    if (!duplicate.conflict) {
      ++harmless;
      continue;
    }
    out << "conflict: " << to_string(duplicate.identity) << ", the first is used\n";
    for (const auto& entry : duplicate.entries) out << "  " << entry.file << ':' << entry.line << '\n';
  }
  for (const auto& warning : catalogue.warnings()) {
    const auto words = warning.reason.text();
    const bool named = words.find(warning.file) != std::string::npos;
    out << "warning: " << (named ? words : fmt::format("{}:{}: {}", warning.file, warning.line, words)) << '\n';
  }
  out << fmt::format("{}, {} of them in several files with the same content\n",
                     counted(catalogue.device_count(), "device"), harmless);
}

Json index_json(const eni::EsiCatalogue& catalogue, const std::vector<eni::DuplicateDevice>& duplicates, Json folders) {
  Json doubles = Json::array(), warnings = Json::array();
  for (const auto& duplicate : duplicates) doubles.push_back(duplicate_json(duplicate));
  for (const auto& w : catalogue.warnings()) {
    warnings.push_back({{"file", w.file}, {"line", w.line}, {"element", w.element}, {"text", w.reason.text()}});
  }
  return {{"database", catalogue.database()},
          {"devices", catalogue.device_count()},
          {"folders", std::move(folders)},
          {"duplicates", doubles},
          {"warnings", warnings}};
}

Status forget(eni::EsiCatalogue& catalogue, const std::vector<std::string>& folders) {
  for (const auto& folder : folders) {
    if (auto status = catalogue.forget_folder(folder); !status) return status;
  }
  return {};
}

void index(Context& context, const IndexOptions& options) {
  auto opened = options.cache.empty() ? Result<eni::EsiCatalogue>(eni::EsiCatalogue::open_default())
                                      : eni::EsiCatalogue::open(options.cache);
  if (!opened) return context.fail_with(opened.error());
  auto& catalogue = *opened;
  if (options.forget) {
    if (const auto status = forget(catalogue, options.folders); !status) context.fail_with(status.error());
    return;
  }
  if (const auto status = catalogue.mend(); !status) return context.fail_with(status.error());
  const InterruptGuard guard;
  const auto callback = [&](const eni::IndexProgress& progress) {
    if (options.progress) {
      context.console.err << fmt::format("{}/{} {}\n", progress.files_done + 1, progress.files, progress.file);
    }
    return !guard.interrupted();
  };
  Json folders = Json::array();
  for (const auto& folder : options.folders) {
    const auto report = catalogue.add_folder(folder, callback);
    if (!report) return context.fail_with(report.error());
    if (report->cancelled) context.exit_code = kAnswerIsNo;
    if (const auto status = catalogue.remember_folder(folder); !status) return context.fail_with(status.error());
    for (const auto& error : eni::unreadable_folders(*report)) context.warn(error);
    folders.push_back(report_json(folder, *report));
    if (!options.json) context.console.out << report_line(folder, *report);
  }
  const auto duplicates = catalogue.duplicates([&] { return !guard.interrupted(); });
  if (!duplicates) return context.fail_with(duplicates.error());
  if (guard.interrupted()) context.exit_code = kAnswerIsNo;
  if (options.json) return context.print(index_json(catalogue, *duplicates, std::move(folders)));
  print_index(context, catalogue, *duplicates);
}

}  // namespace

void add_esi_index(CLI::App& esi, Context& context) {
  auto* command =
      esi.add_subcommand("index", "Read folders of ESI files into the catalogue, and say what is wrong in them");
  auto options = std::make_shared<IndexOptions>();
  command->add_option("folders", options->folders, "Folders of ESI files, with the folders below them")->required();
  command->add_option("--cache", options->cache, "Database of the catalogue (otherwise in the user's cache folder)");
  auto* forget = command->add_flag("--forget", options->forget, "Take the folders out of the catalogue");
  command->add_flag("--progress", options->progress, "Name each file that is read on the error stream")
      ->excludes(forget);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { index(context, *options); });
}

}  // namespace syncline::cli
