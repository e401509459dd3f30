// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "protocol/al_state.h"
#include "support/types.h"

namespace syncline {

/// Who calculates the outputs of a running network from its inputs. The process image is that of the
/// configuration: a slave's part begins at SlaveConfig::send and SlaveConfig::receive.
class CyclicApplication {
 public:
  struct Cycle {
    std::uint64_t number = 0;        // counts from going online
    Nanoseconds time = 0;            // host clock, scheduled time of this cycle
    AlState state = AlState::kNone;  // of the master
  };
  virtual ~CyclicApplication() = default;
  /// Once a cycle in the thread that runs it, before the frames are sent; must neither block nor allocate. `inputs`
  /// came back in the cycle before; `outputs` keep what the cycle before has left in them.
  virtual void run(const Cycle& cycle, std::span<const std::uint8_t> inputs, std::span<std::uint8_t> outputs) = 0;
};

}  // namespace syncline
