// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bench/soak_machine.h"

/// Machines of soak_faults that are no line: of any shape, led by any clock.
namespace syncline::bench {

/// Three to 22 slaves, wired to the one before or further back; who leads, the cycle time, limit, mode and host.
void draw_whole_tree(SoakMachine& machine, Random& random);

/// "; 0 generic, 1 servo-y (32 bit) at 0B, ...".
[[nodiscard]] std::string tree_text(const test::SimulatedNetwork& network);

}  // namespace syncline::bench
