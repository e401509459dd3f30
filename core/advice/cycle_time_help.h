// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "reasons/reason.h"
#include "support/result.h"
#include "support/types.h"

/// Which bus cycles all slaves of a project accept, and who refuses the others and why.
namespace syncline {

struct Project;

struct CycleRefusal {
  int slave = -1;       // position; -1 = the bus itself
  std::string name;     // of the slave
  Reason reason;        // one sentence
  bool partly = false;  // the slave takes the cycle, but not as it should
  bool operator==(const CycleRefusal&) const = default;
};

struct CycleCandidate {
  Nanoseconds cycle = 0;
  std::vector<CycleRefusal> refusals;  // empty: everybody accepts it without loss
  [[nodiscard]] bool accepted() const { return std::ranges::all_of(refusals, &CycleRefusal::partly); }
};

struct CycleTimeHelp {
  /// Cycles that all accept are multiples of `step` between `shortest` and `longest`, and may have to meet the fixed
  /// SYNC cycles that the candidates name. Empty optional: nobody limits it.
  Nanoseconds step = 1;
  std::optional<Nanoseconds> shortest, longest;
  std::vector<CycleCandidate> candidates;  // ascending; the project's own and the usual ones, and the shortest that fit
  CycleCandidate current;                  // the project's own
};

/// Rules: SYNC0 cycles that device families take, and object 0x1C32:05; SYNC cycles that an operation mode fixes divide
/// the cycle of the slave's task or are multiples of it; factors divide it without a rest; object 0x60C2 can say it;
/// the frames fit into it. Errors as compile().
[[nodiscard]] Result<CycleTimeHelp> cycle_time_help(const Project& project);

}  // namespace syncline
