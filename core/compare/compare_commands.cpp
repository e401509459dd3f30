// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "compare/difference_list.h"
#include "compare/network_compare.h"
#include "config/init_cmd.h"
#include "config/slave_config.h"
#include "protocol/fmmu.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline::comparison {
namespace {

using Group = DifferenceGroup;

bool in(std::uint16_t ado, std::uint16_t first, unsigned size) { return ado >= first && ado < first + size; }

/// Which group a command belongs to by the register that it goes to.
Group group_of(const InitCmd& cmd) {
  if (is_logical(cmd.command)) return Group::kCommands;
  // SyncManagers 0 and 1 of a slave with mailbox are written on IP, before those of the process data.
  if (in(cmd.ado, reg::kSyncManager, 0x80)) {
    const bool mailbox =
        std::ranges::any_of(cmd.transitions, [](Transition t) { return t == Transition::kIP || t == Transition::kIB; });
    return mailbox ? Group::kMailbox : Group::kProcessData;
  }
  if (in(cmd.ado, reg::kFmmu, 0x100)) return Group::kProcessData;
  if (in(cmd.ado, reg::kCyclicUnitControl, 0x30)) return Group::kClocks;
  return Group::kCommands;
}

/// To the slave itself, or to whom the address does not matter.
bool goes_to(const InitCmd& cmd, const SlaveConfig& slave) {
  if (is_fixed_address(cmd.command)) return cmd.adp == slave.station_address;
  return !is_auto_increment(cmd.command) || cmd.adp == slave.auto_increment_address;
}

/// A copy without what follows from the slave's place: addresses, and the logical start of FMMUs.
InitCmd without_place(const SlaveConfig& slave, const InitCmd& cmd) {
  InitCmd copy = cmd;
  copy.comment.clear();
  // Marked, since a foreign address may be 0 as well.
  if (goes_to(cmd, slave))
    copy.adp = 0;
  else
    copy.logical_address = 1;
  if (cmd.ado == reg::kStationAddress && cmd.data.size() == 2 &&
      (cmd.data[0] | cmd.data[1] << 8) == slave.station_address) {
    copy.data = {0, 0};
  }
  if (in(cmd.ado, reg::kFmmu, 0x100) && cmd.data.size() == Fmmu::kSize) {
    const Fmmu fmmu = Fmmu::decode(std::span<const std::uint8_t, Fmmu::kSize>(cmd.data.data(), Fmmu::kSize));
    // One that is switched off or only cleared lies nowhere: its bytes are what they are.
    if (!fmmu.active) return copy;
    // In bit-packed images the start bit follows from the slaves before, and the length in bytes from that: what
    // counts is how many bits there are.
    std::fill_n(copy.data.begin(), 8, std::uint8_t{0});
    store_le(std::span<std::uint8_t>(copy.data), fmmu.bit_length());
    // Bits that have no meaning there are kept.
    copy.data[6] = cmd.data[6] & 0xF8;
    copy.data[7] = cmd.data[7] & 0xF8;
  }
  return copy;
}

std::vector<InitCmd> without_place(const SlaveConfig& slave, Group group) {
  std::vector<InitCmd> out;
  for (const InitCmd& cmd : slave.init_cmds) {
    if (group_of(cmd) == group) out.push_back(without_place(slave, cmd));
  }
  return out;
}

/// Commands of one transition, whatever they are for.
std::vector<InitCmd> of_transition(const SlaveConfig& slave, Transition transition) {
  std::vector<InitCmd> out;
  for (const InitCmd& cmd : slave.init_cmds) {
    if (std::ranges::find(cmd.transitions, transition) != cmd.transitions.end())
      out.push_back(without_place(slave, cmd));
  }
  return out;
}

/// The groups are compared each for itself: a setting that went behind the request that needs it changes none of them.
bool same_order(const SlaveConfig& left, const SlaveConfig& right) {
  for (auto t = Transition::kII; t <= Transition::kBI; t = static_cast<Transition>(static_cast<int>(t) + 1)) {
    if (of_transition(left, t) != of_transition(right, t)) return false;
  }
  return true;
}

bool is_state_time_out(const InitCmd& left, const InitCmd& right) {
  const auto time_less = [](InitCmd cmd) {
    cmd.timeout_ms.reset();
    if (cmd.validate) cmd.validate->timeout_ms = 0;
    return cmd;
  };
  return (left.ado == reg::kAlControl || left.ado == reg::kAlStatus) && time_less(left) == time_less(right);
}

void report(const std::vector<InitCmd>& left, const std::vector<InitCmd>& right, Group group, DifferenceList& out) {
  SlaveConfig one, other;
  one.init_cmds = left;
  other.init_cmds = right;
  for (const NetworkDifference& difference : compare_slaves(one, other, "")) {
    // "..., init command 12 (FPWR 0:0x0810, PS)" or, where one side has none, the command in left or right.
    const bool paired = difference.field != "missing" && difference.field != "additional";
    const auto bracket = difference.where.find('(');
    std::string command = paired && bracket != std::string::npos
                              ? difference.where.substr(bracket + 1, difference.where.size() - bracket - 2)
                              : difference.left + difference.right;
    if (const auto place = command.find(" 0:"); place != std::string::npos) command.erase(place + 1, 2);
    if (paired) {
      out.add(
          group,
          what("difference-init-command-field", fig::text<"command">(command), fig::phrase<"field">(difference.field)),
          difference.left.empty() ? "none" : difference.left, difference.right.empty() ? "none" : difference.right);
    } else {
      out.add(group, "difference-init-command", difference.field == "missing" ? command : "",
              difference.field == "missing" ? "" : command);
    }
  }
}

void compare_time_outs(const StateTimeouts& left, const StateTimeouts& right, DifferenceList& out) {
  out.number(Group::kCommands, "difference-time-out-to-preop", left.preop, right.preop, " ms");
  out.number(Group::kCommands, "difference-time-out-to-safeop-and-op", left.safeop_op, right.safeop_op, " ms");
  out.number(Group::kCommands, "difference-time-out-back-to-init", left.back_to_init, right.back_to_init, " ms");
  out.number(Group::kCommands, "difference-time-out-back-to-safeop", left.back_to_safeop, right.back_to_safeop, " ms");
}

}  // namespace

void compare_commands(const SlaveConfig& left, const SlaveConfig& right, DifferenceList& out) {
  compare_time_outs(left.timeouts, right.timeouts, out);
  const bool time_outs_differ = out.has(Group::kCommands);
  if (left.init_cmds == right.init_cmds) return;
  constexpr Group kGroups[] = {Group::kMailbox, Group::kProcessData, Group::kClocks, Group::kCommands};
  for (const Group group : kGroups) {
    if (group != Group::kCommands && out.has(group)) continue;  // explained by the setting
    auto one = without_place(left, group);
    auto other = without_place(right, group);
    if (group == Group::kCommands && time_outs_differ && one.size() == other.size()) {
      for (std::size_t i = 0; i < one.size(); ++i) {
        if (is_state_time_out(one[i], other[i])) one[i] = other[i];
      }
    }
    if (one == other) continue;
    report(one, other, group, out);
    // What the words above do not tell apart.
    if (!out.has(group)) out.add(group, "difference-init-commands", "", "");
  }
  const bool told = std::ranges::any_of(kGroups, [&](Group group) { return out.has(group); });
  if (!told && !same_order(left, right)) out.add(Group::kCommands, "difference-init-commands/order", "", "");
}

}  // namespace syncline::comparison
