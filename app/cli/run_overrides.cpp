// SPDX-License-Identifier: Apache-2.0
#include "app/cli/run_overrides.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/cli/terminal_reason.h"
#include "app/composition/load_config.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "protocol/registers.h"
#include "settings/settings_keys.h"

namespace syncline::cli {
namespace {

constexpr std::string_view kPrefix = "master.dc.", kShort = "dcm.";

struct Override {
  std::string key, value;
};

Result<std::vector<Override>> parse(std::span<const std::string> texts) {
  std::vector<Override> overrides;
  for (const auto& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) return fail(ErrorCode::kBadValue, text, in_terminal("use KEY=VALUE"));
    auto key = text.substr(0, equals);
    if (key.starts_with(kShort)) key = std::string(kPrefix) + key.substr(kShort.size());
    overrides.push_back({std::move(key), text.substr(equals + 1)});
  }
  return overrides;
}

Status set_all(Project& project, std::span<const Override> overrides) {
  for (const auto& [key, value] : overrides) {
    if (auto status = set_setting(project, key, value); !status) return status;
  }
  return {};
}

/// A command of the file writes the slaves' time control loops, after the master has done so.
bool file_writes_loop(const NetworkConfig& config) {
  const auto writes_loop = [](const InitCmd& command) {
    return command.ado >= reg::kSpeedCounterStart && command.ado <= reg::kFilterDepthSpeedCounter &&
           !is_logical(command.command) && writes(command.command);
  };
  return std::ranges::any_of(config.master.init_cmds, writes_loop) ||
         std::ranges::any_of(config.slaves,
                             [&](const auto& slave) { return std::ranges::any_of(slave.init_cmds, writes_loop); });
}

/// What an ENI says in its frames and commands cannot be another thing for one run; empty when the key can be set.
std::string_view why_not(const NetworkConfig& config, std::string_view key) {
  if (!key.starts_with(kPrefix))
    return "of an ENI only master.dc.* can be set for a run; change the project and export it again";
  key.remove_prefix(kPrefix.size());
  if (key == "enabled" || key == "all_slaves")
    return "an ENI's start-up commands say which slaves use distributed clocks";
  if (key == "show_64bit_system_time") return "an ENI's cyclic frames say how many bytes of the system time are read";
  const bool loop = key == "standard_loop_values" || key.starts_with("loop.");
  if (loop && file_writes_loop(config)) return "the ENI's start-up commands write 0x0930 to 0x0935 themselves";
  return {};
}

Status set_all(NetworkConfig& config, std::span<const Override> overrides) {
  for (const auto& [key, value] : overrides) {
    if (const auto reason = why_not(config, key); !reason.empty()) {
      return fail(ErrorCode::kBadValue, key, in_terminal(reason));
    }
  }
  // The rules of a project's settings hold; its slaves play no part in these.
  Project project;
  project.master.cycle_time = config.cycle_time();
  project.master.dc = config.dc;
  project.slaves.resize(config.slaves.size());
  if (auto status = set_all(project, overrides); !status) return status;
  config.dc = project.master.dc;
  return {};
}

}  // namespace

Result<CompileResult> load_with_overrides(const std::string& path, std::string_view network,
                                          std::span<const std::string> overrides) {
  const auto parsed = parse(overrides);
  if (!parsed) return tl::unexpected(parsed.error());
  auto project = eni::load_project(path, network);
  if (project) {
    if (auto status = set_all(*project, *parsed); !status) return tl::unexpected(status.error());
    return compile(*project, {});
  }
  if (project.error().code != ErrorCode::kNotThatKindOfFile) return tl::unexpected(project.error());
  auto config = eni::read_eni(path);
  if (!config) return tl::unexpected(config.error());
  if (auto status = check_network_of_eni(path, network); !status) return tl::unexpected(status.error());
  if (auto status = set_all(*config, *parsed); !status) return tl::unexpected(status.error());
  return CompileResult{std::move(*config), {}};
}

}  // namespace syncline::cli
