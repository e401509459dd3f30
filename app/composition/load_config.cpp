// SPDX-License-Identifier: Apache-2.0
#include "app/composition/load_config.h"

#include "eni/eni_file.h"
#include "eni/project_file.h"

namespace syncline {

Result<CompileResult> load_config(const std::string& path, const CompileOptions& options, std::string_view network) {
  const auto project = eni::load_project(path, network);
  if (project) return compile(*project, options);
  if (project.error().code != ErrorCode::kNotThatKindOfFile) return tl::unexpected(project.error());
  auto config = eni::read_eni(path);
  if (!config) return tl::unexpected(config.error());
  return CompileResult{std::move(*config), {}};
}

}  // namespace syncline
