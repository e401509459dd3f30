// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "check/network_view.h"
#include "config/init_cmd.h"
#include "config/network_config.h"
#include "protocol/registers.h"

/// Remarks on what readers and masters of the field do with a file that is right in itself.
namespace syncline::checker {
namespace {

bool checks_identity(const SlaveConfig& slave) {
  return std::ranges::any_of(slave.init_cmds, [](const InitCmd& cmd) {
    return cmd.ado == reg::kSiiData && !is_logical(cmd.command) && cmd.validate && !cmd.validate->data.empty();
  });
}

}  // namespace

void check_dialects(const NetworkView& view, Findings& findings) {
  const NetworkConfig& config = view.config;
  for (std::size_t t = 0; t < config.cyclic.size(); ++t) {
    if (!config.cyclic[t].cycle_time_given) {
      findings.add("ENI-DIA-01", {PlaceKind::kTask, t});
    }
  }
  if (config.image.command_data_offset != 0) {
    findings.add("ENI-DIA-02", {PlaceKind::kImage}, fig::count<"bytes">(config.image.command_data_offset));
  }
  if (const auto& drift = view.drift_compensation; drift && drift->cmd->command == Command::kFrmw) {
    findings.add("ENI-DIA-03", drift->place());
  }
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    if (!config.slaves[i].init_cmds.empty() && !checks_identity(config.slaves[i])) {
      findings.add("ENI-DIA-04", {PlaceKind::kSlave, i});
    }
  }
}

}  // namespace syncline::checker
