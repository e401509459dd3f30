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

}  // namespace syncline
