// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compile/compile.h"
#include "config/network_config.h"
#include "config/project.h"
#include "findings/finding.h"
#include "support/result.h"

namespace syncline {

struct CompileResult;

/// A file that can be run or exported: a project is compiled, an ENI is read as it is. `network` chooses one of a
/// project file that holds several, see eni::find_network; kBadValue where there is one and the file is an ENI.
[[nodiscard]] Result<CompileResult> load_config(const std::string& path, const CompileOptions& options = {},
                                                std::string_view network = {});

struct LoadedConfig {
  NetworkConfig config;
  std::vector<Finding> findings;
  bool is_eni = false;
  std::optional<Project> source{};  // what was compiled
};
/// The same for those who want to know which of the two it was.
[[nodiscard]] Result<LoadedConfig> load_any_config(const std::string& path, const CompileOptions& options = {},
                                                   std::string_view network = {});

/// An ENI is of one network: kBadValue where one is asked for, which would be passed over.
[[nodiscard]] Status check_network_of_eni(const std::string& path, std::string_view network);

/// A project file, or the project that an ENI lets be seen (recover_project() without ESI files).
[[nodiscard]] Result<Project> load_any_project(const std::string& path, std::string_view network = {});

}  // namespace syncline
