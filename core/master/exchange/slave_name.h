// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace syncline {

struct NetworkConfig;

/// How a slave of the configuration is called in errors: by its position, and its name where it has one.
[[nodiscard]] std::string slave_name(const NetworkConfig& config, std::size_t slave);

}  // namespace syncline
