// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "master/scan/wiring_tree_builder.h"

namespace syncline::wiring {

/// Times that are none of the master's frame. A closed ring brings another adapter's to a port behind which nobody is
/// (Entry::foreign), and a port's register may hold what it held before (Entry::untimed). Taken out is what leaves the
/// fewest ports without a slave and contradicts itself least: nobody keeps a frame for longer than it was away from
/// whoever he hangs at. Where that leaves several, what is the least unlikely: no hop is shorter than two ESCs, and who
/// is put where he is not leaves a long one where he is. `tries`: of the tree, counted down. Pure.
void forget_foreign_times(std::span<const PortReport> slaves, std::vector<Entry>& entries, int& tries);

}  // namespace syncline::wiring
