// SPDX-License-Identifier: Apache-2.0
#include "config/command_text.h"

#include <fmt/format.h>

#include "config/cyclic_frame.h"
#include "config/init_cmd.h"

namespace syncline {

std::string hex_text(std::span<const std::uint8_t> bytes) {
  std::string out;
  for (const std::uint8_t byte : bytes) {
    out += fmt::format("{:02x}", byte);
  }
  return out;
}

std::string transitions_text(const std::vector<Transition>& list) {
  std::string out;
  for (const Transition transition : list) {
    out += out.empty() ? "" : ",";
    out += transition_name(transition);
  }
  return out;
}

std::string states_text(const std::vector<AlState>& list) {
  std::string out;
  for (const AlState state : list) {
    out += out.empty() ? "" : ",";
    out += al_state_name(state);
  }
  return out;
}

template <class Cmd>
std::string address_text(const Cmd& cmd) {
  if (is_logical(cmd.command)) {
    return fmt::format("{} 0x{:08x}", command_name(cmd.command), cmd.logical_address);
  }
  return fmt::format("{} {}:0x{:04x}", command_name(cmd.command), cmd.adp, cmd.ado);
}
template std::string address_text(const InitCmd&);
template std::string address_text(const CyclicCmd&);

}  // namespace syncline
