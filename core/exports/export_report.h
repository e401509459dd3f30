// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "findings/finding.h"

namespace syncline {
struct NetworkConfig;
struct Project;
}  // namespace syncline

namespace syncline::exports {

/// A setting that no line of the ENI says, for whoever configures the master.
struct UnsaidSetting {
  std::string key, label, value;  // value with its unit
};

/// What an export knows beside the configuration. Texts are somebody's own and are escaped here.
struct ReportFacts {
  std::string project;  // its file or name
  std::string date, program, dialect;
  std::string eni_file;             // its name
  std::size_t eni_bytes = 0;        // its size
  std::vector<Finding> findings{};  // of the compiler, then of the checker of ENI files
  /// From which the configuration was compiled: vendors, operation modes and Sync Units. Null: it was read from an ENI.
  const Project* source = nullptr;
  std::vector<UnsaidSetting> unsaid{};
};

/// What an integrator hands over with an ENI, as one HTML file in English: no scripts, nothing from elsewhere, light,
/// for A4. The same bytes for the same facts; numbers without a locale.
[[nodiscard]] std::string export_report(const NetworkConfig& config, const ReportFacts& facts);

}  // namespace syncline::exports
