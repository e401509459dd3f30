// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/init_cmd.h"

namespace syncline {

/// ENI Slave/HotConnect: this slave and those of its group that follow it may be absent, and may be connected anywhere.
struct HotConnectConfig {
  std::string group;
  std::uint16_t member_count = 1;  // slaves of the group, this one being the first
  /// By which it is known: commands to the device at a position, that read and validate its alias (0x0012) or its
  /// explicit device ID.
  std::vector<InitCmd> identify_cmds;
  bool operator==(const HotConnectConfig&) const = default;
  /// When the alias is what they compare.
  [[nodiscard]] std::optional<std::uint16_t> alias() const;
};

}  // namespace syncline
