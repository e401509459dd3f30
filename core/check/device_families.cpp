// SPDX-License-Identifier: Apache-2.0
#include "check/network_view.h"
#include "families/families.h"
#include "families/family_problems.h"

namespace syncline::checker {
namespace {

using families::Problem;

std::string_view code_of(const Problem& problem) {
  switch (problem.topic) {
    case Problem::Topic::kCycleRefused:
      return "ENI-DEV-01";
    case Problem::Topic::kCyclePartly:
      return "ENI-DEV-02";
    case Problem::Topic::kObjects:
      return "ENI-DEV-03";
    case Problem::Topic::kErrorLimit:
      return "ENI-DEV-04";
    case Problem::Topic::kErrorLimitOff:
      return "ENI-DEV-05";
    case Problem::Topic::kModeNeedsDc:
      return "ENI-DEV-06";
    case Problem::Topic::kSyncType:
      return problem.refused ? "ENI-DEV-07" : "ENI-DEV-08";
    case Problem::Topic::kCanCycle:
      return problem.refused ? "ENI-DEV-09" : "ENI-DEV-10";
  }
  return {};
}

ConfigPlace place_of(const Problem& problem, std::size_t slave) {
  if (problem.coe_command) return {PlaceKind::kCoeCmd, slave, *problem.coe_command};
  const bool cycle = problem.topic == Problem::Topic::kCycleRefused || problem.topic == Problem::Topic::kCyclePartly;
  return {cycle ? PlaceKind::kDc : PlaceKind::kSlave, slave};
}

}  // namespace

void check_device_families(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const SlaveConfig& slave = view.config.slaves[i];
    for (Problem& problem : families::problems(families::find(slave.identity), slave, view.config.cycle_time())) {
      findings.add(code_of(problem), place_of(problem, i), std::move(problem.text));
    }
  }
}

}  // namespace syncline::checker
