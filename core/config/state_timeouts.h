// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// ESI Info/StateMachine/Timeout, ms; ETG defaults where the ESI is silent.
struct StateTimeouts {
  std::uint32_t preop = 3000;
  std::uint32_t safeop_op = 10000;
  std::uint32_t back_to_init = 5000;
  std::uint32_t back_to_safeop = 200;
  bool operator==(const StateTimeouts&) const = default;
};

}  // namespace syncline
