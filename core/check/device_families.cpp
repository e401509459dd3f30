// SPDX-License-Identifier: Apache-2.0
#include "check/network_view.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "families/families.h"
#include "families/family_problems.h"

namespace syncline::checker {
namespace {

using families::Problem;

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
      findings.take(std::move(problem.finding), place_of(problem, i));
    }
  }
}

}  // namespace syncline::checker
