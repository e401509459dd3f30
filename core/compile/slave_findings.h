// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct Finding;
struct SlaveConfig;
}  // namespace syncline

namespace syncline::compiler {

struct SlavePlan;

/// PDO assignment, memory, DC times, mailbox, topology of one slave, and what its device family says of the
/// configuration made from the plan.
void find_slave_problems(std::vector<Finding>& out, const SlavePlan& slave, const SlaveConfig& config);

}  // namespace syncline::compiler
