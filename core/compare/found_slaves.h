// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/project.h"

namespace syncline {

/// How a slave of a project stands to what a scan found.
enum class FoundKind : std::uint8_t {
  kMatched,      // the same device in the same place
  kRewired,      // the same, plugged in elsewhere
  kMoved,        // the same device in another order
  kRevision,     // the same product in another revision
  kOtherDevice,  // another device in this place
  kMissing,      // in the project only
  kExtra,        // on the bus only
};

/// A line of the comparison.
struct FoundSlave {
  FoundKind kind = FoundKind::kMatched;
  std::optional<std::size_t> ours, found;  // positions in the project and on the bus
  bool moved = false;                      // in another order, whatever else differs
  bool operator==(const FoundSlave&) const = default;
};

/// The slaves of a project and those of a project that was made of a scan: in the order of the bus, missing ones where
/// they would stand. Slaves are known again by identity and order; serial numbers, names and settings do not count.
[[nodiscard]] std::vector<FoundSlave> compare_found(const Project& ours, const Project& found);

struct TakenOver {
  Project project;
  /// Settings of slaves that came in another revision and that this one does not take: their keys in `project`.
  std::vector<std::string> lost;
};
/// The project with the lines whose `take` is true as they are on the bus; the others stay as they are. Extra slaves
/// come in, missing ones go, moved and rewired ones get their new place, another revision keeps the settings that it
/// takes. Station addresses stay unique, the reference clock stays the same slave. Pure; `take` is as long as `lines`.
[[nodiscard]] TakenOver take_over(const Project& ours, const Project& found, std::span<const FoundSlave> lines,
                                  const std::vector<bool>& take);

}  // namespace syncline
