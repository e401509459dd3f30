// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "config/slave_config.h"

/// Which slaves of a configuration belong to a hot-connect group: the one that begins it and those that follow it,
/// until it has its members or another group begins.
namespace syncline {

/// First slave of the group that this slave belongs to, if any. Allocates nothing.
[[nodiscard]] std::optional<std::size_t> hot_connect_head(std::span<const SlaveConfig> slaves, std::size_t slave);
/// The same of all slaves, for who asks for each.
[[nodiscard]] std::vector<std::optional<std::size_t>> hot_connect_heads(std::span<const SlaveConfig> slaves);

}  // namespace syncline
