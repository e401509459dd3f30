// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "findings/finding.h"

namespace syncline {

/// A finding that several slaves have alike: only their position and the setting's key differ.
struct FoldedFinding {
  Finding finding;          // its slave figures name all of them; the place is that of the first
  std::vector<int> slaves;  // positions, rising; one, or none for what is about no slave
};

/// For readers: what three slaves or more have alike is one entry, in the place of its first.
[[nodiscard]] std::vector<FoldedFinding> folded(std::span<const Finding> findings);

/// "3 to 17, 19, 21 to 30"
[[nodiscard]] std::string ranges_text(std::span<const int> positions);

}  // namespace syncline
