// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "findings/finding.h"

namespace syncline {

struct NetworkConfig;

enum class DifferenceGroup : std::uint8_t {
  kSlaves,       // which devices, in which place
  kWiring,       // ports, aliases, hot connect
  kProcessData,  // PDOs, SyncManagers
  kMailbox,
  kStartup,   // CoE, SoE and other start-up commands
  kClocks,    // distributed clocks of master and slaves
  kCommands,  // init commands that none of the others explains, time-outs
  kCyclic,    // cycle times, frames
  kImage,     // places in the process image
  kMaster,
  kRunTime,  // what no ENI carries, see compare_run_time()
};
[[nodiscard]] std::string_view group_name(DifferenceGroup group);  // "slaves", "process data" ...

/// One difference in meaning between two configurations.
struct ConfigDifference {
  DifferenceGroup group = DifferenceGroup::kMaster;
  std::optional<std::size_t> left_slave, right_slave;  // positions; none = the network
  std::string slave_name;
  Finding what;             // a row of core/findings/difference_words.h: "SYNC0 cycle"
  std::string left, right;  // "1 ms"; "" = there is none
  bool operator==(const ConfigDifference&) const = default;
};
/// "slave 3 (Drive)", "slave 3, now 4 (Drive)", "network"
[[nodiscard]] std::string place_text(const ConfigDifference& difference);
/// "slave 3 (Drive): SYNC0 cycle 1 ms -> 2 ms"
[[nodiscard]] std::string describe(const ConfigDifference& difference);

/// What two configurations make a machine do differently, grouped by slave (network first) and kind. Slaves are paired
/// by identity, name and order, so that one more slave is one difference. Spelling does not count: names (but of
/// variables, where most are the same), comments, PDOs that are not assigned, addresses that only follow from the
/// order, where a tool puts data in the image as a whole. A command whose change follows from a setting that is
/// reported is not reported again; see compare_networks() for all.
[[nodiscard]] std::vector<ConfigDifference> compare_configs(const NetworkConfig& left, const NetworkConfig& right);

}  // namespace syncline
