// SPDX-License-Identifier: Apache-2.0
#include "config/network_config.h"

#include "config/hot_connect_groups.h"

namespace syncline {

std::optional<std::uint16_t> NetworkConfig::reference_clock() const {
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (slaves[i].dc && slaves[i].dc->reference_clock) {
      return static_cast<std::uint16_t>(i);
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> NetworkConfig::hot_connect_head(std::size_t slave) const {
  return syncline::hot_connect_head(slaves, slave);
}

}  // namespace syncline
