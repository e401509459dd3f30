// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "protocol/al_state.h"

/// Short texts of command fields for comparisons and logs.
namespace syncline {

[[nodiscard]] std::string hex_text(std::span<const std::uint8_t> bytes);          // "00110e00"
[[nodiscard]] std::string transitions_text(const std::vector<Transition>& list);  // "IP,PS"
[[nodiscard]] std::string states_text(const std::vector<AlState>& list);          // "PREOP,SAFEOP"
/// "FPWR 1001:0x0810" or "LRW 0x10000000".
template <class Cmd>
[[nodiscard]] std::string address_text(const Cmd& cmd);
/// The bytes that go onto the wire: data, or DataLength zeros.
template <class Cmd>
[[nodiscard]] std::vector<std::uint8_t> payload(const Cmd& cmd) {
  return cmd.data_length ? std::vector<std::uint8_t>(*cmd.data_length) : cmd.data;
}

}  // namespace syncline
