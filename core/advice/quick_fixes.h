// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "settings/setting.h"

namespace syncline {

struct Finding;
struct Project;

/// One value for one setting, of one slave or of several, after which the finding is gone.
struct QuickFix {
  const settings::Setting* setting = nullptr;
  std::vector<settings::Place> places;  // where it is set
  settings::Value value;
};

/// Values of the setting that the finding (of compile(), or of check_network() with its setting) names with which the
/// project no longer has the finding and has no other of the same weight or more that it did not have before: each was
/// tried on a copy of the project and compiled. Those that change least first, no more than `most`; empty: no single
/// value of that setting does it. Of a finding of a run (its code stands in run_slaves_words.h or run_bus_words.h),
/// which no compilation has: the switch that its row names, switched on where it is off, or the number that its figures
/// advise (so much more than it was: while it is left to the master); its place names a slave of the project. `slaves`:
/// where the same was found; empty: at the finding's place alone. Pure; takes a compilation for each value that is
/// tried, at most 24.
[[nodiscard]] std::vector<QuickFix> quick_fixes(const Project& project, const Finding& finding,
                                                std::span<const int> slaves = {}, std::size_t most = 3);

}  // namespace syncline
