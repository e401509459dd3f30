// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/init_cmd.h"

/// The master as it is exported and run (ETG.2100, Master).
namespace syncline {

/// ENI Master/EoE: sizes of the switch that the master is between its EoE slaves.
struct EoeSwitchSettings {
  std::uint32_t max_ports = 2;
  std::uint32_t max_frames = 120;
  std::uint32_t max_macs = 100;
  bool operator==(const EoeSwitchSettings&) const = default;
};

struct MasterConfig {
  std::string name;
  std::array<std::uint8_t, 6> destination_mac{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  std::array<std::uint8_t, 6> source_mac{};
  bool eoe = false;  // any EoE slave
  std::optional<std::uint16_t> mailbox_state_count;
  std::vector<InitCmd> init_cmds;
  EoeSwitchSettings eoe_settings;                   // when `eoe`
  std::uint32_t mailbox_state_start = 0x0900'0000;  // logical address of the status bits
  std::uint16_t ether_type = 0x88A4;
  bool operator==(const MasterConfig&) const = default;
};

}  // namespace syncline
