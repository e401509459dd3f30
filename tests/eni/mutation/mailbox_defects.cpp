// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "eni/mutation/defects.h"

namespace syncline::test {
namespace {

MailboxConfig* mailbox(NetworkConfig& config, Random& random) {
  auto* slave = pick_if(config.slaves, random, [](const SlaveConfig& s) {
    return s.mailbox && s.mailbox->send.length != 0 && !s.init_cmds.empty();
  });
  return slave != nullptr ? &*slave->mailbox : nullptr;
}

template <class Wanted>
StartupCommand* start_up(NetworkConfig& config, Random& random, Wanted wanted) {
  std::vector<StartupCommand*> found;
  for (SlaveConfig& slave : config.slaves) {
    if (!slave.mailbox) continue;
    for (CoeInitCmd& cmd : slave.mailbox->coe_commands) {
      if (cmd.command.enabled && !cmd.command.data.empty() && !cmd.command.complete_access && wanted(cmd.command))
        found.push_back(&cmd.command);
    }
  }
  return found.empty() ? nullptr : found[pick(random, found.size())];
}

bool is_list(const StartupCommand& cmd) {
  return (cmd.index >= 0x1C12 && cmd.index <= 0x1C13) || (cmd.index >= 0x1600 && cmd.index < 0x1800) ||
         (cmd.index >= 0x1A00 && cmd.index < 0x1C00);
}

bool change_length(NetworkConfig& config, Random& random) {
  MailboxConfig* box = mailbox(config, random);
  if (box == nullptr) return false;
  auto& channel = random.next() % 2 == 0 ? box->send : box->receive;
  channel.length = static_cast<std::uint16_t>(channel.length + 2 * (1 + pick(random, 20)));
  return true;
}

bool change_start(NetworkConfig& config, Random& random) {
  MailboxConfig* box = mailbox(config, random);
  if (box == nullptr) return false;
  auto& channel = random.next() % 2 == 0 ? box->send : box->receive;
  channel.start = static_cast<std::uint16_t>(channel.start + 2 * (1 + pick(random, 20)));
  return true;
}

bool lose_protocol(NetworkConfig& config, Random& random) {
  auto* slave = pick_if(config.slaves, random, [](const SlaveConfig& s) {
    return s.mailbox && s.mailbox->coe && !s.mailbox->coe_commands.empty();
  });
  if (slave != nullptr) slave->mailbox->coe = false;
  return slave != nullptr;
}

bool move_status_bit(NetworkConfig& config, Random& random) {
  auto* slave =
      pick_if(config.slaves, random, [](const SlaveConfig& s) { return s.mailbox && s.mailbox->status_bit_address; });
  if (slave != nullptr) *slave->mailbox->status_bit_address += 1 + static_cast<std::uint32_t>(pick(random, 3));
  return slave != nullptr;
}

bool lengthen_list_entry(NetworkConfig& config, Random& random) {
  StartupCommand* cmd = start_up(config, random, is_list);
  if (cmd != nullptr) cmd->data.push_back(0);
  return cmd != nullptr;
}

bool change_list_entry(NetworkConfig& config, Random& random) {
  StartupCommand* cmd = start_up(config, random, [](const StartupCommand& c) { return is_list(c) && c.sub_index > 0; });
  if (cmd != nullptr) cmd->data[pick(random, cmd->data.size())] ^= static_cast<std::uint8_t>(1 + pick(random, 15));
  return cmd != nullptr;
}

bool lose_data(NetworkConfig& config, Random& random) {
  StartupCommand* cmd = start_up(config, random, [](const StartupCommand&) { return true; });
  if (cmd != nullptr) cmd->data.clear();
  return cmd != nullptr;
}

bool wrong_transition(NetworkConfig& config, Random& random) {
  StartupCommand* cmd = start_up(config, random, [](const StartupCommand&) { return true; });
  if (cmd != nullptr) cmd->transitions = {Transition::kII};
  return cmd != nullptr;
}

/// The emptying of a list goes behind its entries.
bool swap_order(NetworkConfig& config, Random& random) {
  auto* slave = pick_if(config.slaves, random, [](const SlaveConfig& s) {
    return s.mailbox && std::ranges::any_of(s.mailbox->coe_commands, [](const CoeInitCmd& cmd) {
             return is_list(cmd.command) && cmd.command.sub_index == 1 && !cmd.command.complete_access;
           });
  });
  if (slave == nullptr) return false;
  auto& commands = slave->mailbox->coe_commands;
  const auto entry = std::ranges::find_if(commands, [](const CoeInitCmd& cmd) {
    return is_list(cmd.command) && cmd.command.sub_index == 1 && !cmd.command.complete_access;
  });
  const auto empty = std::find_if(commands.begin(), entry, [&](const CoeInitCmd& cmd) {
    return cmd.command.index == entry->command.index && cmd.command.sub_index == 0;
  });
  if (empty == entry) return false;
  std::iter_swap(empty, entry);
  return true;
}

bool change_value(NetworkConfig& config, Random& random) {
  StartupCommand* cmd = start_up(config, random, [](const StartupCommand& c) { return !is_list(c); });
  if (cmd != nullptr) cmd->data[0] ^= static_cast<std::uint8_t>(1 + pick(random, 15));
  return cmd != nullptr;
}

constexpr DefectKind kMailboxKinds[] = {{"another size of a mailbox", true, change_length},
                                        {"another place of a mailbox", true, change_start},
                                        {"start-up commands without their protocol", true, lose_protocol},
                                        {"another bit for a mailbox's state", true, move_status_bit},
                                        {"a download that is too long", true, lengthen_list_entry},
                                        {"another PDO or entry written", true, change_list_entry},
                                        {"a download without data", true, lose_data},
                                        {"a download in INIT", true, wrong_transition},
                                        {"entries of a list before it is emptied", true, swap_order},
                                        {"another value of an object", false, change_value}};

}  // namespace

std::span<const DefectKind> mailbox_defects() { return kMailboxKinds; }

}  // namespace syncline::test
