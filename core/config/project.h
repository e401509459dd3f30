// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "config/master_settings.h"
#include "config/monitor_view.h"
#include "config/slave_settings.h"

namespace syncline {

/// Everything the user decides; saved as the project file, turned into a NetworkConfig by compile().
struct Project {
  MasterSettings master;
  std::vector<SlaveSettings> slaves;  // frame order
  std::string name;                   // of the network, where a machine has several
  std::vector<MonitorView> views;     // what the monitor draws; nothing that is compiled or runs depends on it
  bool operator==(const Project&) const = default;
};

/// A machine with one EtherCAT network or several, each with a master of its own: what a project file holds.
struct Machine {
  std::string name;
  std::vector<Project> networks;
  bool operator==(const Machine&) const = default;
};

}  // namespace syncline
