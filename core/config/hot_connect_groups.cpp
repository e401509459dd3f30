// SPDX-License-Identifier: Apache-2.0
#include "config/hot_connect_groups.h"

namespace syncline {
namespace {

/// `head`: the slave that begins a group, nearest in front of `slave`.
std::optional<std::size_t> head_of(std::span<const SlaveConfig> slaves, std::size_t head, std::size_t slave) {
  return slave - head < slaves[head].hot_connect->member_count ? std::optional(head) : std::nullopt;
}

}  // namespace

std::optional<std::size_t> hot_connect_head(std::span<const SlaveConfig> slaves, std::size_t slave) {
  for (std::size_t head = slave + 1; head-- > 0;) {
    if (slaves[head].hot_connect) return head_of(slaves, head, slave);
  }
  return std::nullopt;
}

std::vector<std::optional<std::size_t>> hot_connect_heads(std::span<const SlaveConfig> slaves) {
  std::vector<std::optional<std::size_t>> heads;
  std::optional<std::size_t> nearest;
  for (std::size_t slave = 0; slave < slaves.size(); ++slave) {
    if (slaves[slave].hot_connect) nearest = slave;
    heads.push_back(nearest ? head_of(slaves, *nearest, slave) : std::nullopt);
  }
  return heads;
}

}  // namespace syncline
