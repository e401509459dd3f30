// SPDX-License-Identifier: Apache-2.0
#include "app/composition/load_config.h"

#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "reasons/because.h"
#include "recover/recover_project.h"

namespace syncline {

Status check_network_of_eni(const std::string& path, std::string_view network) {
  if (network.empty()) return {};
  return fail(ErrorCode::kBadValue, "the network",
              because("{file} is an ENI, which holds one alone: leave the network out", path));
}

Result<LoadedConfig> load_any_config(const std::string& path, const CompileOptions& options, std::string_view network) {
  auto project = eni::load_project(path, network);
  if (project) {
    auto compiled = compile(*project, options);
    if (!compiled) return tl::unexpected(compiled.error());
    return LoadedConfig{std::move(compiled->config), std::move(compiled->findings), false, std::move(*project)};
  }
  if (project.error().code != ErrorCode::kNotThatKindOfFile) return tl::unexpected(project.error());
  auto config = eni::read_eni(path);
  if (!config) return tl::unexpected(config.error());
  if (auto status = check_network_of_eni(path, network); !status) return tl::unexpected(status.error());
  return LoadedConfig{std::move(*config), {}, true};
}

Result<CompileResult> load_config(const std::string& path, const CompileOptions& options, std::string_view network) {
  auto loaded = load_any_config(path, options, network);
  if (!loaded) return tl::unexpected(loaded.error());
  return CompileResult{std::move(loaded->config), std::move(loaded->findings)};
}

Result<Project> load_any_project(const std::string& path, std::string_view network) {
  auto project = eni::load_project(path, network);
  if (project || project.error().code != ErrorCode::kNotThatKindOfFile) return project;
  const auto config = eni::read_eni(path);
  if (!config) return tl::unexpected(config.error());
  if (auto status = check_network_of_eni(path, network); !status) return tl::unexpected(status.error());
  return recover_project(*config).project;
}

}  // namespace syncline
