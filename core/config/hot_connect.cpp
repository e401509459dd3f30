// SPDX-License-Identifier: Apache-2.0
#include "config/hot_connect.h"

#include "protocol/registers.h"

namespace syncline {

std::optional<std::uint16_t> HotConnectConfig::alias() const {
  for (const auto& command : identify_cmds) {
    if (command.ado != reg::kStationAlias || !command.validate || command.validate->data.size() < 2) continue;
    return static_cast<std::uint16_t>(command.validate->data[0] | command.validate->data[1] << 8);
  }
  return std::nullopt;
}

}  // namespace syncline
