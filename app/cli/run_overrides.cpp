// SPDX-License-Identifier: Apache-2.0
#include "app/cli/run_overrides.h"

#include "config/settings_keys.h"

namespace syncline::cli {
namespace {

constexpr std::string_view kPrefix = "master.dc.", kShort = "dcm.";

}  // namespace

Status override_settings(NetworkConfig& config, std::span<const std::string> overrides) {
  // The rules of a project's settings hold; its slaves play no part in these.
  Project project;
  project.master.cycle_time = config.cycle_time();
  project.master.dc = config.dc;
  project.slaves.resize(config.slaves.size());
  for (const auto& text : overrides) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) return fail(ErrorCode::kBadValue, text, "use KEY=VALUE");
    auto key = text.substr(0, equals);
    if (key.starts_with(kShort)) key = std::string(kPrefix) + key.substr(kShort.size());
    if (!key.starts_with(kPrefix)) {
      return fail(ErrorCode::kBadValue, key, "only master.dc.* can be set for a run; change the project instead");
    }
    if (auto status = set_setting(project, key, text.substr(equals + 1)); !status) return status;
  }
  config.dc = project.master.dc;
  return {};
}

}  // namespace syncline::cli
