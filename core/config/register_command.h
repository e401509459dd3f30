// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/al_state.h"

namespace syncline {

/// Register access of the user's own at a transition (ETG.2100, InitCmd): of one slave by its station address (FPRD,
/// FPWR), or of the master to all slaves (BRD, BWR).
struct RegisterCommand {
  static constexpr std::uint32_t kUsualTimeoutMs = 1000;

  std::vector<Transition> transitions{Transition::kPS};
  bool read = false;               // else written
  std::uint16_t address = 0;       // byte address in the ESC
  std::vector<std::uint8_t> data;  // what is written, in wire order; of a read as many bytes, zeros
  /// What a read has to bring within `timeout_ms`, and which bits of it count; empty: anything, and all bits.
  std::vector<std::uint8_t> expected, mask;
  std::uint32_t timeout_ms = kUsualTimeoutMs;
  bool after_slaves = false;  // of the master: behind the slaves' own commands of that transition (no BeforeSlave)
  bool enabled = true;        // off: kept in the project, not in the ENI
  std::string comment;
  bool operator==(const RegisterCommand&) const = default;
};

}  // namespace syncline
