// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace syncline {
struct NetworkConfig;
}  // namespace syncline

namespace syncline::exports {

/// One init command of a configuration in words of the ENI: what is sent to whom at which transition.
struct InitCommandRow {
  int slave = -1;              // position; -1: the master's, to all slaves
  std::string transitions;     // "IP,BI"
  std::string protocol;        // "ESC", "CoE", "SoE", "AoE", "EoE", "FoE", "VoE"
  std::string command;         // "FPWR", "download", "write"
  std::string target{};        // "0x0130 AL control", "0x1C12:01", "S-0-0001"
  std::uint32_t address = 0;   // of it: register, object index or IDN
  std::uint8_t sub_index = 0;  // of objects
  std::vector<std::uint8_t> data{};
  std::optional<std::uint16_t> length{};        // instead of data: so many zeros
  std::optional<std::uint16_t> expected_wkc{};  // Cnt
  std::string validate{};                       // "= 01 00 (mask FF 00)"
  std::uint32_t timeout_ms = 0;                 // of the validation or of the mailbox; 0: the master's default
  std::uint32_t retries = 0;
  bool before_slave = false;
  bool enabled = true;
  std::string comment{};
  bool operator==(const InitCommandRow&) const = default;
};

/// Those of the master first, then of each slave: register commands in their order, then its mailbox's. Pure.
[[nodiscard]] std::vector<InitCommandRow> init_commands(const NetworkConfig& config);

}  // namespace syncline::exports
