// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "compile/compile.h"
#include "config/project.h"
#include "config/sim_config.h"
#include "link/link.h"
#include "link/simulated_host.h"
#include "link/simulated_link.h"
#include "sim/sim_bus.h"
#include "support/clock.h"
#include "tests/support/machine_devices.h"

namespace syncline::test {

/// The same devices as a project and as a simulated line.
struct SimulatedNetwork {
  Project project;
  SimConfig sim;

  void add(const DeviceDescription& device, const std::string& behaviour = "generic");
  [[nodiscard]] NetworkConfig compiled(const CompileOptions& options = {}) const;
  /// Null when the segment cannot be made.
  [[nodiscard]] std::unique_ptr<Link> link(Clock& clock) const;
};

}  // namespace syncline::test
