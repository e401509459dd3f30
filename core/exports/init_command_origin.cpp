// SPDX-License-Identifier: Apache-2.0
#include "exports/init_command_origin.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>

#include "config/command_text.h"
#include "config/project.h"
#include "config/startup_messages.h"
#include "config/startup_origin.h"
#include "exports/init_commands.h"

namespace syncline::exports {
namespace {

using enum InitCommandOrigin;

struct Range {
  std::uint16_t first, last;
  InitCommandOrigin origin;
};

/// Registers (ESC data sheet II, register overview).
constexpr Range kRegisters[] = {
    {0x0010, 0x0013, kAddresses}, {0x0100, 0x0111, kPorts},        {0x0120, 0x0135, kStateMachine},
    {0x0300, 0x0313, kPorts},     {0x0400, 0x0443, kWatchdogs},    {0x0500, 0x050F, kDeviceCheck},
    {0x0600, 0x06FF, kFmmus},     {0x0800, 0x087F, kSyncManagers}, {0x0900, 0x09FF, kClocks},
};
/// Objects (ETG.1000.6, 5.6.7; ETG.1020).
constexpr Range kObjects[] = {
    {0x1600, 0x17FF, kPdoMapping}, {0x1A00, 0x1BFF, kPdoMapping}, {0x1C10, 0x1C2F, kPdoAssignment}};

InitCommandOrigin look_up(std::span<const Range> ranges, std::uint32_t address, InitCommandOrigin otherwise) {
  const auto found = std::ranges::find_if(
      ranges, [address](const Range& range) { return address >= range.first && address <= range.last; });
  return found == ranges.end() ? otherwise : found->origin;
}

bool is_own(const InitCommandRow& row, const std::vector<RegisterCommand>& commands) {
  return std::ranges::any_of(commands, [&](const RegisterCommand& own) {
    return own.enabled && own.address == row.address && own.comment == row.comment && own.data == row.data &&
           transitions_text(own.transitions) == row.transitions;
  });
}

InitCommandOrigin origin_of_message(const InitCommandRow& row, const SlaveSettings& slave) {
  const auto protocol = std::ranges::find(kMessageProtocols, row.protocol, &MessageProtocol::name);
  if (protocol == kMessageProtocols.end()) return kSettings;
  const auto& messages = slave.*protocol->startup;
  const auto message = std::ranges::find_if(messages, [&](const MailboxInitCmd& one) {
    return one.data == row.data && transitions_text(one.transitions) == row.transitions && one.comment == row.comment;
  });
  if (message == messages.end()) return kSettings;
  return is_from_esi(*message, slave.device, protocol->type) ? kEsi : kStartup;
}

}  // namespace

InitCommandOrigin origin_of(const InitCommandRow& row, const Project& project) {
  const auto at = static_cast<std::size_t>(row.slave);
  const auto* slave = row.slave >= 0 && at < project.slaves.size() ? &project.slaves[at] : nullptr;
  if (row.protocol == "ESC") {
    const auto& own = slave != nullptr ? slave->register_commands : project.master.register_commands;
    return is_own(row, own) ? kOwn : look_up(kRegisters, row.address, kSettings);
  }
  if (slave == nullptr) return kSettings;
  if (row.protocol == "SoE") {
    const auto same = [&](const SoeCommand& command) { return command.idn == row.address; };
    const auto own = std::ranges::find_if(slave->soe_startup, same);
    if (own == slave->soe_startup.end()) return kSettings;
    return is_from_esi(*own, slave->device) ? kEsi : kStartup;
  }
  if (row.protocol != "CoE") return origin_of_message(row, *slave);
  const auto same = [&](const StartupCommand& command) {
    return command.index == row.address && command.sub_index == row.sub_index;
  };
  const auto own = std::ranges::find_if(slave->startup, same);
  if (own != slave->startup.end()) return is_from_esi(*own, slave->device) ? kEsi : kStartup;
  return look_up(kObjects, row.address, kSettings);
}

}  // namespace syncline::exports
