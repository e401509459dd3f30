// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "compare/network_compare.h"
#include "compile/compile.h"
#include "config/project.h"

namespace syncline {

/// The ESI device of an identity, exact revision; nullptr when there is none.
using DeviceLookup = std::function<const DeviceDescription*(const Identity& identity)>;

struct RecoveredProject {
  Project project;
  EniDialect dialect = EniDialect::kEcEngineer;  // in which the ENI's image is laid out
  std::vector<Finding> findings;                 // what could not be recovered, and what was guessed
  /// What compiling the project in that dialect makes different from the ENI.
  std::vector<NetworkDifference> differences;
};

/// A project from which compile() makes this configuration again, as far as a project can say it. Slaves get the ESI's
/// device where `devices` has it and it fits what the ENI assigns, else a device of what the ENI shows. Start-up
/// commands are those that compile() does not generate. Never fails: what is odd is a finding.
[[nodiscard]] RecoveredProject recover_project(const NetworkConfig& config, const DeviceLookup& devices = {});

/// The dialect in which the cyclic commands are laid out.
[[nodiscard]] EniDialect dialect_of(const NetworkConfig& config);

}  // namespace syncline
