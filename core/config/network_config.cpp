// SPDX-License-Identifier: Apache-2.0
#include "config/network_config.h"

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
  for (std::size_t head = slave + 1; head-- > 0;) {
    if (!slaves[head].hot_connect) continue;
    const bool member = slave - head < slaves[head].hot_connect->member_count;
    return member ? std::optional(head) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace syncline
