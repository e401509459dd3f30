// SPDX-License-Identifier: Apache-2.0
#include "compile/family_findings.h"

#include <fmt/format.h>

#include <algorithm>

#include "compile/coe_init_cmds.h"
#include "compile/finding_list.h"
#include "compile/slave_plan.h"
#include "compile/sync_init_cmds.h"
#include "config/slave_settings.h"
#include "config/startup_origin.h"
#include "families/families.h"
#include "families/family_problems.h"
#include "settings/sync_settings.h"

namespace syncline::compiler {
namespace {

using families::Problem;

/// The start-up command of the project that is the cause, as "startup.K"; "" for one that the compiler made.
std::string startup_key(const SlavePlan& slave, const SlaveConfig& config, const Problem& problem) {
  if (!problem.coe_command) return {};
  const StartupCommand& cause = config.mailbox->coe_commands[*problem.coe_command].command;
  const auto& startup = slave.settings->startup;
  for (std::size_t k = startup.size(); k-- > 0;) {
    if (startup[k].enabled && startup[k].index == cause.index && startup[k].sub_index == cause.sub_index) {
      return fmt::format("startup.{}", k);
    }
  }
  return {};
}

/// The setting that stands for the object in question; "" when it is not used.
std::string setting_key(const SlaveSettings& slave, const Problem& problem) {
  switch (problem.topic) {
    case Problem::Topic::kErrorLimit:
    case Problem::Topic::kErrorLimitOff:
      return slave.sync.error_limit ? "sync.error_limit" : "";
    case Problem::Topic::kSyncType:
      return slave.sync.type ? "sync.type" : "";
    case Problem::Topic::kCanCycle:
      return slave.can.cycle ? "can.cycle_us" : "";
    default:
      return {};
  }
}

std::string key_of(const SlavePlan& slave, const SlaveConfig& config, const Problem& problem) {
  if (auto key = setting_key(*slave.settings, problem); !key.empty()) return key;
  if (auto key = startup_key(slave, config, problem); !key.empty()) return key;
  switch (problem.topic) {
    case Problem::Topic::kCycleRefused:
    case Problem::Topic::kCyclePartly:
      return "dc.sync0.cycle_us";
    case Problem::Topic::kObjects:
      return problem.outputs ? "pdo.rx" : "pdo.tx";
    case Problem::Topic::kModeNeedsDc:
      return "dc.op_mode";
    case Problem::Topic::kErrorLimit:
    case Problem::Topic::kErrorLimitOff:
      return "sync.error_limit";
    case Problem::Topic::kSyncType:
      return "sync.type";
    case Problem::Topic::kCanCycle:
      return "can.cycle_us";
  }
  return {};
}

/// A setting and the user's own start-up command write different values to one object.
void check_contradictions(FindingList& findings, const SlavePlan& slave) {
  const auto& startup = slave.settings->startup;
  for (const StartupCommand& command : sync_commands(slave)) {
    for (std::size_t k = 0; k < startup.size(); ++k) {
      const bool same =
          startup[k].enabled && startup[k].index == command.index && startup[k].sub_index == command.sub_index;
      if (!same || startup[k].data == command.data || is_from_esi(startup[k], slave.device())) continue;
      findings.add_at(fmt::format("startup.{}", k), "startup-contradiction",
                      fig::text<"object">(fmt::format("0x{:04X}:{:02X}", command.index, command.sub_index)),
                      fig::text<"command">(command.comment));
    }
  }
}

void check_minimum_cycle(FindingList& findings, const SlavePlan& slave) {
  const auto least = families::minimum_cycle(slave.device());
  if (!least || slave.cycle_time >= *least) return;
  findings.add("cycle-below-minimum", fig::time<"cycle">(slave.cycle_time), fig::time<"least">(*least));
}

}  // namespace

void find_family_problems(FindingList& findings, const SlavePlan& slave, const SlaveConfig& config) {
  for (const Problem& problem : families::problems(families::find(slave.device()), config, slave.cycle_time)) {
    const auto key = key_of(slave, config, problem);
    findings.take(problem.finding, key);
  }
  check_minimum_cycle(findings, slave);
  if (const auto status = check_sync_settings(*slave.settings); !status) {
    findings.add_at(status.error().subject, "sync-setting-invalid", fig::reason<"reason">(status.error().detail));
  }
  check_contradictions(findings, slave);
}

}  // namespace syncline::compiler
