// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "check/check_rule.h"
#include "config/network_config.h"

namespace syncline {

/// Which kind of thing of a NetworkConfig is meant; says how many of the indexes of a ConfigPlace count.
enum class PlaceKind : std::uint8_t {
  kConfig,  // all of it
  kMaster,
  kMasterInitCmd,  // command
  kSlave,          // slave
  kSlaveInitCmd,   // slave, command
  kSyncManager,    // slave, index in sync_managers
  kPdo,            // slave, index in pdos
  kMailbox,        // slave
  kCoeCmd,         // slave, command
  kHotConnect,     // slave
  kDc,             // slave
  kTask,           // task
  kFrame,          // task, frame
  kCyclicCmd,      // task, frame, command
  kImage,
  kInput,   // variable
  kOutput,  // variable
};

/// Names a thing of a NetworkConfig, so that a reader that knows lines can say where it stands.
struct ConfigPlace {
  PlaceKind kind = PlaceKind::kConfig;
  std::size_t first = 0, second = 0, third = 0;
  auto operator<=>(const ConfigPlace&) const = default;
  /// Position of the slave it belongs to, -1 for what belongs to none.
  [[nodiscard]] int slave() const;
};

struct CheckFinding {
  std::string_view code;  // of a CheckRule
  ConfigPlace place;
  std::string what;  // the facts, in words
  bool operator==(const CheckFinding&) const = default;
};

/// Everything in a configuration that a master or a slave would stumble over, or that looks like a slip, by the rules
/// of check_rules(). Pure, bounded by the size of the configuration (n log n), for any values in it.
[[nodiscard]] std::vector<CheckFinding> check_network(const NetworkConfig& config);

}  // namespace syncline
