// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/slave_name.h"

#include <fmt/format.h>

#include "config/network_config.h"

namespace syncline {

std::string slave_name(const NetworkConfig& config, std::size_t slave) {
  const auto& name = config.slaves[slave].name;
  return name.empty() ? fmt::format("slave {}", slave) : fmt::format("slave {} ({})", slave, name);
}

}  // namespace syncline
