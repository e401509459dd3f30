// SPDX-License-Identifier: Apache-2.0
#include "recover/recovered_commands.h"

#include <algorithm>
#include <optional>

#include "config/network_config.h"
#include "config/project.h"
#include "protocol/registers.h"

namespace syncline::recover {
namespace {

using Commands = std::vector<InitCmd>;

struct Range {
  unsigned first, last;
};
/// What other settings stand for whenever a tool writes it: addresses, ports, state machine, error counters, EEPROM,
/// FMMUs, SyncManagers (ESC data sheet II, register overview).
constexpr Range kOfSettings[] = {{0x0010, 0x0013}, {0x0100, 0x0111}, {0x0120, 0x0135}, {0x0140, 0x0153},
                                 {0x0300, 0x0313}, {0x0500, 0x050F}, {0x0600, 0x06FF}, {0x0800, 0x08FF}};

Range range_of(const InitCmd& cmd) { return {cmd.ado, cmd.ado + std::max<unsigned>(cmd.length(), 1) - 1}; }
bool overlap(Range left, Range right) { return left.first <= right.last && right.first <= left.last; }

std::optional<RegisterCommand> own_command(const InitCmd& cmd, bool of_master, std::uint16_t station) {
  const bool read = cmd.command == (of_master ? Command::kBrd : Command::kFprd);
  const bool write = cmd.command == (of_master ? Command::kBwr : Command::kFpwr);
  if ((!read && !write) || (!of_master && cmd.adp != station)) return std::nullopt;
  const bool compared = cmd.validate && cmd.validate->type == ValidateType::kEqual;
  if ((cmd.validate && !compared) || (write && cmd.validate)) return std::nullopt;
  RegisterCommand own;
  own.transitions = cmd.transitions;
  own.read = read;
  own.address = cmd.ado;
  own.data = cmd.data_length ? std::vector<std::uint8_t>(*cmd.data_length) : cmd.data;
  if (read) std::ranges::fill(own.data, std::uint8_t{0});
  if (compared) {
    own.expected = cmd.validate->data;
    own.mask = cmd.validate->mask;
    own.timeout_ms = cmd.validate->timeout_ms;
  }
  own.after_slaves = of_master && !cmd.before_slave;
  own.comment = cmd.comment;
  return own;
}

std::vector<RegisterCommand> own_commands(const Commands& wanted, const Commands& generated, bool of_master,
                                          std::uint16_t station) {
  Commands rest, missing = generated;
  for (const InitCmd& cmd : wanted) {
    const auto found = std::ranges::find(missing, cmd);
    if (found != missing.end()) {
      missing.erase(found);
    } else {
      rest.push_back(cmd);
    }
  }
  const auto stands_for_a_setting = [&](const InitCmd& cmd) {
    const auto range = range_of(cmd);
    return std::ranges::any_of(kOfSettings, [&](Range known) { return overlap(known, range); }) ||
           std::ranges::any_of(generated, [&](const InitCmd& other) { return overlap(range_of(other), range); });
  };
  std::vector<RegisterCommand> own;
  for (const InitCmd& cmd : rest) {
    if (!missing.empty() && stands_for_a_setting(cmd)) continue;
    if (auto command = own_command(cmd, of_master, station)) own.push_back(std::move(*command));
  }
  return own;
}

}  // namespace

void recover_register_commands(Project& project, const NetworkConfig& config, const NetworkConfig& compiled) {
  constexpr std::uint16_t kAll = 0;
  project.master.register_commands = own_commands(config.master.init_cmds, compiled.master.init_cmds, true, kAll);
  for (std::size_t i = 0; i < project.slaves.size() && i < compiled.slaves.size(); ++i) {
    project.slaves[i].register_commands =
        own_commands(config.slaves[i].init_cmds, compiled.slaves[i].init_cmds, false, config.slaves[i].station_address);
  }
}

}  // namespace syncline::recover
