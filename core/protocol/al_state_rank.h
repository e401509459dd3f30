// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "protocol/al_state.h"

namespace syncline {

/// How far a slave has come on its way to OP: BOOT stands beside the ladder INIT, PREOP, SAFEOP, OP, below PREOP; 0 for
/// no state at all.
[[nodiscard]] constexpr int al_state_rank(AlState state) {
  switch (state) {
    case AlState::kNone:
      return 0;
    case AlState::kInit:
      return 1;
    case AlState::kBoot:
      return 2;
    case AlState::kPreop:
      return 3;
    case AlState::kSafeop:
      return 4;
    case AlState::kOp:
      return 5;
  }
  return 0;
}

}  // namespace syncline
