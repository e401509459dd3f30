// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/identity.h"

namespace syncline {

/// By what a slave is known again. An empty name matches every name.
struct SlaveKey {
  Identity identity;
  std::string name;
};

struct SlavePairing {
  /// For each slave of the left its counterpart in the right.
  std::vector<std::optional<std::size_t>> right_of;
  std::vector<std::optional<std::size_t>> left_of;
  /// Left slaves whose counterpart stands in another order.
  std::vector<bool> moved;
};

/// Cells of the table of an alignment; what differs in a larger one is paired by place.
inline constexpr std::size_t kMostCells = 4'000'000;

/// The pairing that keeps order and identity of as many slaves as possible; then slaves that stand elsewhere; then
/// other devices in the same place. n x m steps for the part that differs, pairing by place beyond 4 million.
[[nodiscard]] SlavePairing pair_slaves(std::span<const SlaveKey> left, std::span<const SlaveKey> right);

}  // namespace syncline
