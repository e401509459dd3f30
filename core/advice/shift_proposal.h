// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "config/dcm_settings.h"

namespace syncline {

struct Project;

enum class ShiftReason : std::uint8_t {
  kClocksOff,        // distributed clocks are switched off for the whole bus
  kNobodyUsesThem,   // no slave has an operation mode with SYNC signals
  kSeveralNetworks,  // one time for all of them: the masters', so that each steers its reference clock
  kOneNetwork,       // the steadiest clock leads, which is a slave's
};

struct ShiftProposal {
  DcmMode mode = DcmMode::kOff;
  ShiftReason reason = ShiftReason::kClocksOff;
  bool operator==(const ShiftProposal&) const = default;
};

/// Off, master shift or bus shift for this project, and why. `several_networks`: more than one EtherCAT network has to
/// run in step. Source: "EtherCAT Master Architecture" (Yaskawa), chapter 2, flow chart. Pure.
[[nodiscard]] ShiftProposal propose_shift(const Project& project, bool several_networks);

}  // namespace syncline
