// SPDX-License-Identifier: Apache-2.0
#include "config/compile/findings.h"

#include "config/compile/master_findings.h"
#include "config/compile/slave_findings.h"

namespace syncline::compiler {

std::vector<Finding> find_problems(const Project& project, const std::vector<SlavePlan>& slaves,
                                   const NetworkConfig& config) {
  std::vector<Finding> findings;
  find_master_problems(findings, project, slaves, config);
  for (const SlavePlan& slave : slaves) {
    find_slave_problems(findings, project, slave);
  }
  return findings;
}

}  // namespace syncline::compiler
