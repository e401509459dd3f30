// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "config/previous_port.h"

namespace syncline {
class WiringTree;
}  // namespace syncline

namespace syncline::ui {

/// Where a slave is drawn: lines go down, branches begin to the right of the slave from which they branch off.
struct TopologyPlace {
  enum class Port : std::uint8_t { kNone, kEntry, kFree, kWayOn, kBranch };

  int row = 0, column = 0;
  std::optional<PreviousPort> previous;
  bool goes_on = false;              // continues the line of the slave before it, else it begins a branch
  int before = -1, next = -1;        // in its line; -1 = the master, nobody
  int first_branch = -1, from = -1;  // the slave from which its line branches off
  std::array<Port, 4> ports{};
};

struct TopologyLayout {
  std::vector<TopologyPlace> slaves;
  int rows = 0, columns = 0;
};

/// The master has row 0; slaves that hang at nobody begin lines of their own. Pure.
[[nodiscard]] TopologyLayout layoutOf(const WiringTree& tree);

}  // namespace syncline::ui
