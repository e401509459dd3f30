// SPDX-License-Identifier: Apache-2.0
#include "config/command_text.h"

#include <fmt/format.h>

#include "config/cyclic_frame.h"
#include "config/init_cmd.h"

namespace syncline {

namespace {

template <class Value, class NameOf>
std::string joined_names(const std::vector<Value>& list, NameOf name_of) {
  std::string out;
  for (const Value value : list) {
    out += out.empty() ? "" : ",";
    out += name_of(value);
  }
  return out;
}

}  // namespace

std::string hex_text(std::span<const std::uint8_t> bytes) {
  std::string out;
  for (const std::uint8_t byte : bytes) {
    out += fmt::format("{:02x}", byte);
  }
  return out;
}

std::string transitions_text(const std::vector<Transition>& list) { return joined_names(list, transition_name); }
std::string states_text(const std::vector<AlState>& list) { return joined_names(list, al_state_name); }

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
