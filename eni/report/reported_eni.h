// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compile/compile.h"
#include "findings/finding.h"
#include "support/result.h"

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::eni {

/// An ENI that is to be written together with a report about it.
struct ReportedEni {
  const NetworkConfig& config;
  EniDialect dialect = EniDialect::kEcEngineer;  // of its spelling
  const Project* source = nullptr;               // null: it was read from an ENI
  std::string name;                              // of the project or its file
  std::string program;                           // with its version
  std::string date;                              // as it is to stand there
  std::vector<Finding> findings;                 // of the compiler
};

/// The report, with what the checker of ENI files finds in `eni`, which is to be written to `eni_path`.
[[nodiscard]] std::string report_of(const ReportedEni& reported, const std::string& eni, const std::string& eni_path);

/// Writes both files. When one of them cannot be written there is none of the two that was not there before:
/// kFileNotWritable names it, also when both paths are the same file.
[[nodiscard]] Status save_reported_eni(const ReportedEni& reported, const std::string& eni_path,
                                       const std::string& report_path);

/// "2026-03-01 14:05 UTC": the moment as it stands in reports, whatever the locale.
[[nodiscard]] std::string report_date();

}  // namespace syncline::eni
