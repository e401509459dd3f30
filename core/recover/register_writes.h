// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "config/init_cmd.h"
#include "protocol/fmmu.h"
#include "protocol/sync_manager.h"

/// What the init commands of an ENI put into a slave's registers on the way up (INIT to OP).
namespace syncline::recover {

struct RegisterWrites {
  std::map<std::uint8_t, SyncManager> sync_managers;  // by number; those that are set, not those that are cleared
  std::map<std::uint8_t, Fmmu> fmmus;
  std::optional<std::uint16_t> reg_0400, reg_0410, reg_0420;
  std::vector<std::uint8_t> pdi;              // what 0x0140 is expected to hold
  std::optional<std::uint8_t> state_request;  // first byte of the AL control write that asks for PREOP
};

[[nodiscard]] RegisterWrites register_writes(const std::vector<InitCmd>& commands);

/// Words of the SII that are compared at INIT to PREOP: word address and expected bytes, in order.
struct SiiCheck {
  std::uint16_t word = 0;
  std::vector<std::uint8_t> expected;
  ValidateType type = ValidateType::kEqual;
};
[[nodiscard]] std::vector<SiiCheck> sii_checks(const std::vector<InitCmd>& commands);

}  // namespace syncline::recover
