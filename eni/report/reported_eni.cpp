// SPDX-License-Identifier: Apache-2.0
#include "eni/report/reported_eni.h"

#include <fmt/chrono.h>

#include <ctime>
#include <filesystem>

#include "compare/compare_run_time.h"
#include "config/project.h"
#include "eni/check/eni_check.h"
#include "eni/format/eni_file.h"
#include "exports/export_report.h"
#include "reasons/because.h"
#include "settings/settings_table.h"
#include "support/distinct_files.h"
#include "support/output_file.h"

namespace syncline::eni {
namespace {

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::vector<exports::UnsaidSetting> unsaid_settings(const Project& project) {
  std::vector<exports::UnsaidSetting> unsaid;
  for (const auto& setting : settings::table()) {
    if (setting.of_slave() || setting.items || !is_unsaid_setting(setting.key)) continue;
    unsaid.push_back({setting.key, setting.words.label, settings::text_with_unit(setting, project, {})});
  }
  return unsaid;
}

}  // namespace

std::string report_of(const ReportedEni& reported, const std::string& eni, const std::string& eni_path) {
  exports::ReportFacts facts;
  facts.project = reported.name;
  facts.date = reported.date;
  facts.program = reported.program;
  facts.dialect = reported.dialect == EniDialect::kTwinCat ? "TwinCAT" : "EC-Engineer";
  facts.eni_file = file_name(eni_path);
  facts.eni_bytes = eni.size();
  facts.findings = reported.findings;
  if (const auto check = check_eni_text(eni, facts.eni_file))
    facts.findings.insert(facts.findings.end(), check->findings.begin(), check->findings.end());
  facts.source = reported.source;
  if (reported.source != nullptr) facts.unsaid = unsaid_settings(*reported.source);
  return exports::export_report(reported.config, facts);
}

/// The report lies beside its place before the ENI gets its name, and gets its own afterwards.
Status save_reported_eni(const ReportedEni& reported, const std::string& eni_path, const std::string& report_path) {
  if (is_same_file(eni_path, report_path)) {
    Error error{ErrorCode::kFileNotWritable};
    error.file = report_path;
    error.detail = because("the ENI goes to this file");
    return fail(std::move(error));
  }
  const auto eni = write_eni(reported.config, style_of(reported.dialect));
  auto eni_file = OutputFile::create(eni_path);
  if (!eni_file) return tl::unexpected(eni_file.error());
  auto report_file = OutputFile::create(report_path);
  if (!report_file) return tl::unexpected(report_file.error());
  const std::pair<OutputFile*, std::string> parts[] = {{&*eni_file, eni},
                                                       {&*report_file, report_of(reported, eni, eni_path)}};
  for (const auto& [file, text] : parts) {
    if (auto status = file->write(text); !status) return status;
    if (auto status = file->flush(); !status) return status;
  }
  for (const auto& part : parts) {
    if (auto status = part.first->finish(); !status) return status;
  }
  return {};
}

std::string report_date() { return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr))); }

}  // namespace syncline::eni
