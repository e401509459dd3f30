// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "eni/mutation/defects.h"
#include "protocol/fmmu.h"
#include "protocol/registers.h"

namespace syncline::test {
namespace {

bool is_fmmu(const InitCmd& cmd) {
  return (writes_to(cmd, Transition::kPS, reg::kFmmu, 0x100) || writes_to(cmd, Transition::kIP, reg::kFmmu, 0x100)) &&
         cmd.data.size() == Fmmu::kSize && (cmd.data[12] & 1) != 0;
}
bool is_process_manager(const InitCmd& cmd) {
  return writes_to(cmd, Transition::kPS, reg::kSyncManager, 0x80) && cmd.data.size() == 8 && (cmd.data[6] & 1) != 0;
}
bool is_manager(const InitCmd& cmd) {
  return is_process_manager(cmd) ||
         (writes_to(cmd, Transition::kIP, reg::kSyncManager, 0x80) && cmd.data.size() == 8 && (cmd.data[6] & 1) != 0);
}
bool is_request(const InitCmd& cmd) {
  return writes_to(cmd, Transition::kIP, reg::kAlControl, 2) || writes_to(cmd, Transition::kPS, reg::kAlControl, 2) ||
         writes_to(cmd, Transition::kSO, reg::kAlControl, 2);
}
bool is_state_check(const InitCmd& cmd) {
  return (on(cmd, Transition::kIP) || on(cmd, Transition::kPS) || on(cmd, Transition::kSO)) &&
         cmd.ado == reg::kAlStatus && cmd.validate && !cmd.validate->data.empty();
}
bool is_identity_check(const InitCmd& cmd) {
  return on(cmd, Transition::kIP) && cmd.ado == reg::kSiiData && cmd.validate && !cmd.validate->data.empty();
}
bool is_address(const InitCmd& cmd) { return writes_to(cmd, Transition::kIP, reg::kStationAddress, 2); }
bool is_needed(const InitCmd& cmd) { return is_fmmu(cmd) || is_manager(cmd) || is_request(cmd) || is_address(cmd); }

/// Another value for one byte.
void spoil(std::vector<std::uint8_t>& bytes, std::size_t at, Random& random) {
  bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1 + random.next() % 255));
}

bool erase(NetworkConfig& config, Random& random, bool (*wanted)(const InitCmd&)) {
  const auto found = pick_command(config, random, wanted);
  if (found) found.slave->init_cmds.erase(found.slave->init_cmds.begin() + static_cast<std::ptrdiff_t>(found.index));
  return static_cast<bool>(found);
}

bool lose_needed(NetworkConfig& config, Random& random) { return erase(config, random, is_needed); }
bool lose_state_check(NetworkConfig& config, Random& random) { return erase(config, random, is_state_check); }

bool spoil_fmmu(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_fmmu);
  if (found) spoil(found->data, pick(random, Fmmu::kSize), random);
  return static_cast<bool>(found);
}

/// One slave's FMMU gets the logical address of another's of the same direction.
bool move_fmmu(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_fmmu);
  if (!found) return false;
  const auto other = pick_command(config, random, [&](const InitCmd& cmd) {
    return is_fmmu(cmd) && &cmd != &*found && cmd.data[11] == found->data[11] && cmd.data != found->data &&
           !std::equal(cmd.data.begin(), cmd.data.begin() + 4, found->data.begin());
  });
  if (other) std::copy_n(other->data.begin(), 4, found->data.begin());
  return static_cast<bool>(other);
}

bool spoil_manager(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_manager);
  if (!found) return false;
  // Start, length, direction and mode in the control byte, activation.
  constexpr std::size_t kBytes[] = {0, 1, 2, 3, 4, 6};
  const std::size_t at = kBytes[pick(random, std::size(kBytes))];
  found->data[at] = static_cast<std::uint8_t>(found->data[at] ^ (at == 4   ? 0x04
                                                                 : at == 6 ? 0x01
                                                                           : 1 << pick(random, 7)));
  return true;
}

bool move_behind_request(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, [](const InitCmd& cmd) {
    return (is_fmmu(cmd) || is_process_manager(cmd)) && on(cmd, Transition::kPS);
  });
  if (!found) return false;
  auto& commands = found.slave->init_cmds;
  std::rotate(commands.begin() + static_cast<std::ptrdiff_t>(found.index),
              commands.begin() + static_cast<std::ptrdiff_t>(found.index) + 1, commands.end());
  return true;
}

bool change_addressee(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_needed);
  if (found) found->adp = static_cast<std::uint16_t>(found->adp + 1 + pick(random, 5));
  return static_cast<bool>(found);
}

bool change_register(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_needed);
  if (found) found->ado = static_cast<std::uint16_t>(found->ado + 4);
  return static_cast<bool>(found);
}

bool change_request(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_request);
  if (!found) return false;
  constexpr std::uint8_t kStates[] = {1, 2, 4, 8};
  const auto old = static_cast<std::uint8_t>(found->data[0] & 0x0F);
  std::uint8_t state = old;
  while (state == old) state = kStates[pick(random, 4)];
  found->data[0] = state;
  return true;
}

bool change_awaited(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_state_check);
  if (!found) return false;
  auto& state = found->validate->data[0];
  state = static_cast<std::uint8_t>(state == 8 ? 1 : state << 1);
  return true;
}

bool change_transition(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, [](const InitCmd& cmd) {
    return cmd.transitions.size() == 1 && (is_fmmu(cmd) || is_process_manager(cmd) || is_request(cmd));
  });
  if (!found) return false;
  found->transitions = {found->transitions[0] == Transition::kPS ? Transition::kOP : Transition::kSP};
  return true;
}

bool change_expected_identity(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_identity_check);
  if (found) spoil(found->validate->data, pick(random, found->validate->data.size()), random);
  return static_cast<bool>(found);
}

bool change_station_address(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_address);
  if (found) spoil(found->data, pick(random, 2), random);
  return static_cast<bool>(found);
}

bool change_count(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, [](const InitCmd& cmd) { return cmd.expected_wkc == 1; });
  if (found) found->expected_wkc = static_cast<std::uint16_t>(2 + pick(random, 3));
  return static_cast<bool>(found);
}

bool change_retries(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, [](const InitCmd&) { return true; });
  if (found) found->retries += 1 + static_cast<std::uint32_t>(pick(random, 9));
  return static_cast<bool>(found);
}

bool change_comparison(NetworkConfig& config, Random& random) {
  const auto found = pick_command(config, random, is_identity_check);
  if (found) found->validate->type = ValidateType::kGreaterOrEqual;
  return static_cast<bool>(found);
}

bool lose_master_command(NetworkConfig& config, Random& random) {
  auto& commands = config.master.init_cmds;
  auto* found = pick_if(commands, random, [](const InitCmd& cmd) {
    return cmd.ado == reg::kFmmu || cmd.ado == reg::kSyncManager || cmd.ado == reg::kStationAddress;
  });
  if (found != nullptr) commands.erase(commands.begin() + (found - commands.data()));
  return found != nullptr;
}

constexpr DefectKind kKinds[] = {{"a command that is needed is missing", true, lose_needed},
                                 {"a check of a state is missing", true, lose_state_check},
                                 {"a byte of an FMMU", true, spoil_fmmu},
                                 {"an FMMU on another's address", true, move_fmmu},
                                 {"a byte of a SyncManager", true, spoil_manager},
                                 {"a setting behind the request that needs it", true, move_behind_request},
                                 {"a command to another slave", true, change_addressee},
                                 {"a command to another register", true, change_register},
                                 {"another state requested", true, change_request},
                                 {"another state awaited", true, change_awaited},
                                 {"another transition", true, change_transition},
                                 {"another identity expected", true, change_expected_identity},
                                 {"another station address written", true, change_station_address},
                                 {"a working counter of a command to one slave", true, change_count},
                                 {"a command of the master is missing", true, lose_master_command},
                                 {"retries", false, change_retries},
                                 {"how the identity is compared", false, change_comparison}};

}  // namespace

bool on(const InitCmd& cmd, Transition transition) {
  return std::ranges::find(cmd.transitions, transition) != cmd.transitions.end();
}

bool writes_to(const InitCmd& cmd, Transition transition, std::uint16_t first, std::uint16_t size) {
  return on(cmd, transition) && writes(cmd.command) && !is_logical(cmd.command) && !cmd.data.empty() &&
         cmd.ado >= first && cmd.ado < first + size;
}

std::span<const DefectKind> command_defects() { return kKinds; }

}  // namespace syncline::test
