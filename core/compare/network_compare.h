// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace syncline {

struct NetworkConfig;
struct SlaveConfig;

struct CompareOptions {
  /// Also compare InputOffs and OutputOffs, which tools count from different starts.
  bool image_offsets = false;
};

/// One difference between two configurations, in words for people.
struct NetworkDifference {
  std::string where;  // "slave 3, init command 12 (FPWR 0x0810, PS)"
  std::string field;  // "data", "time-out", "missing", "additional" ...
  std::string left;   // value in the first configuration, "" when it has no such command
  std::string right;
  bool operator==(const NetworkDifference&) const = default;
};
[[nodiscard]] std::string describe(const NetworkDifference& difference);

/// Compares what a master would do: the init commands of master and slaves, CoE commands and cyclic commands, in order,
/// with transitions or states, command, address, bytes, retries, time-outs, validation and working counter. Comments,
/// names, PDO lists and variables do not count. A command that one side lacks is reported once; the rest is compared
/// with its counterpart.
[[nodiscard]] std::vector<NetworkDifference> compare_networks(const NetworkConfig& left, const NetworkConfig& right,
                                                              const CompareOptions& options = {});

/// The same for one slave; `where` starts with `name`.
[[nodiscard]] std::vector<NetworkDifference> compare_slaves(const SlaveConfig& left, const SlaveConfig& right,
                                                            const std::string& name);

}  // namespace syncline
