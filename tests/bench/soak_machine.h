// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "bench/soak_fault_kinds.h"
#include "support/random.h"
#include "tests/support/simulated_network.h"

namespace syncline::bench {

/// What a machine looks like.
enum class SoakShape {
  kLine,   // a terminal, two servos, a drive, a gateway and a terminal in a line
  kDrawn,  // with what the seed adds: a branch, a task, a hot-connect group, and all that faults must be told on all
           // the same
  kTree,   // such slaves in any order, in branches of branches; any clock leads
};

/// What faults are thrown at.
struct SoakMachine {
  SoakShape shape = SoakShape::kLine;
  test::SimulatedNetwork network;
  std::array<DcmMode, 2> modes{DcmMode::kBusShift, DcmMode::kMasterShift};  // one segment after the other
  std::size_t reference = 0;                                                // who leads
};

[[nodiscard]] SoakMachine soak_machine(Random& random, SoakShape shape);

/// Whom a fault of this kind can hit: those that the kind names, and those behind the line, or of a tree, that are like
/// them.
[[nodiscard]] std::vector<int> victims(const SoakMachine& machine, const SoakFaultKind& kind);

/// Kinds that can hit somebody.
[[nodiscard]] std::vector<const SoakFaultKind*> kinds_for(const SoakMachine& machine);
/// Of a slave's SYNC0, or of the machine; -1: of the machine. ns.
[[nodiscard]] Nanoseconds own_cycle(const SoakMachine& machine, int slave);

/// "14 slaves, slave 1 leads, ..."
[[nodiscard]] std::string text_of(const SoakMachine& machine);

}  // namespace syncline::bench
