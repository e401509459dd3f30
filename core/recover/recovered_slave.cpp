// SPDX-License-Identifier: Apache-2.0
#include "recover/recovered_slave.h"

#include <fmt/format.h>

#include <algorithm>

#include "compile/eoe_ip.h"
#include "compile/finding_list.h"
#include "config/module_slots.h"
#include "config/startup_messages.h"
#include "recover/recovered_dc.h"
#include "recover/recovered_device.h"
#include "recover/register_writes.h"
#include "support/byte_order.h"

namespace syncline::recover {
namespace {

using compiler::FindingList;

bool same_mapping(const Pdo& left, const Pdo& right) {
  return std::ranges::equal(left.entries, right.entries, [](const PdoEntry& l, const PdoEntry& r) {
    return l.index == r.index && l.sub_index == r.sub_index && l.bit_length == r.bit_length;
  });
}

/// What an ESI lacks to be the device of this slave; "" when nothing.
std::string misfit(const DeviceDescription& device, const SlaveConfig& slave) {
  for (const auto& manager : slave.sync_managers) {
    if (manager.pdos.empty()) continue;
    const bool there = manager.number < device.sync_managers.size() &&
                       device.sync_managers[manager.number].type == manager.description.type &&
                       device.sync_managers[manager.number].start_address == manager.description.start_address;
    if (!there) return fmt::format("it has no such SyncManager {}", manager.number);
  }
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    for (const std::uint16_t index : assigned_pdos(slave, direction)) {
      const Pdo* pdo = find_pdo(device.pdos(direction), index);
      if (pdo == nullptr) return fmt::format("it has no PDO 0x{:04X}", index);
      const auto used = std::ranges::find_if(slave.pdos, [&](const ConfiguredPdo& configured) {
        return configured.direction == direction && configured.pdo.index == index;
      });
      if (used != slave.pdos.end() && pdo->fixed && !same_mapping(*pdo, used->pdo)) {
        return fmt::format("its fixed PDO 0x{:04X} maps other entries", index);
      }
    }
  }
  return {};
}

/// What the list of modules (ETG.5001.1, 0xF030) downloads for each place, 0 where there is none; empty: no such list.
std::vector<std::uint32_t> module_idents(const SlaveConfig& slave) {
  constexpr std::uint16_t kModuleIdentList = 0xF030;
  constexpr std::size_t kCount = 2, kIdent = 4;  // bytes of a complete access
  std::vector<std::uint32_t> idents;
  if (!slave.mailbox) return idents;
  for (const auto& cmd : slave.mailbox->coe_commands) {
    const auto sub_index = cmd.command.sub_index;
    const auto& data = cmd.command.data;
    if (cmd.command.index != kModuleIdentList) continue;
    if (cmd.command.complete_access) {
      for (std::size_t at = sub_index == 0 ? kCount : 0; at + kIdent <= data.size(); at += kIdent) {
        idents.push_back(load_le<std::uint32_t>(std::span(data).subspan(at)));
      }
    } else if (sub_index > 0 && data.size() == kIdent) {
      idents.resize(std::max<std::size_t>(idents.size(), sub_index));
      idents[sub_index - 1U] = load_le<std::uint32_t>(data);
    }
  }
  return idents;
}

/// Only those of the list are plugged; one that fits nowhere is missing with its PDOs, which misfit() tells.
void plug_modules(SlaveSettings& settings, const std::vector<std::uint32_t>& idents) {
  if (idents.empty() || !settings.device.slots) return;
  for (const auto& place : slot_places(settings.device)) {
    const auto ident = place.number < idents.size() ? idents[place.number] : 0;
    (void)plug_module(settings, place.number, ident != 0 ? std::optional(ident) : std::nullopt);
  }
}

DeviceDescription with_listed_modules(const DeviceDescription& device, const SlaveConfig& slave) {
  const auto idents = module_idents(slave);
  if (idents.empty() || !device.slots) return device;
  auto trial = default_slave(device, 0);
  plug_modules(trial, idents);
  return device_with_modules(trial);
}

DeviceDescription choose_device(const SlaveConfig& slave, const DeviceLookup& devices, Nanoseconds cycle,
                                FindingList& findings) {
  const DeviceDescription* found = devices ? devices(slave.identity) : nullptr;
  if (found == nullptr) {
    findings.add("esi-missing", fig::text<"identity">(to_string(slave.identity)));
    return recovered_device(slave, cycle);
  }
  if (const auto why = misfit(with_listed_modules(*found, slave), slave); !why.empty()) {
    findings.add("esi-not-taken", fig::text<"type">(found->type), fig::text<"reason">(why));
    return recovered_device(slave, cycle);
  }
  return *found;
}

void recover_pdos(SlaveSettings& settings, const SlaveConfig& slave) {
  settings.assigned_rx_pdos = assigned_pdos(slave, PdoDirection::kRx);
  settings.assigned_tx_pdos = assigned_pdos(slave, PdoDirection::kTx);
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    auto& assigned = settings.assigned_pdos(direction);
    if (!assigned.empty() || !slave.pdos.empty()) continue;
    for (const Pdo& pdo : settings.device.pdos(direction)) {
      if (pdo.sync_manager) assigned.push_back(pdo.index);
    }
  }
  const auto device = device_with_modules(settings);
  for (const auto& [direction, pdo] : slave.pdos) {
    const Pdo* of_device = find_pdo(device.pdos(direction), pdo.index);
    if (of_device != nullptr && !of_device->fixed && !same_mapping(*of_device, pdo)) {
      settings.changed_pdos.push_back(pdo);
    }
  }
}

void recover_checks(SlaveSettings& settings, const std::vector<SiiCheck>& checks) {
  settings.check = {};
  settings.check.vendor = settings.check.product = false;
  for (const SiiCheck& check : checks) {
    constexpr std::size_t kWord = 2;
    switch (check.word) {
      case 0x08:
        settings.check.vendor = true;
        break;
      case 0x0A:
        settings.check.product = true;
        break;
      case 0x0C:
        settings.check.revision = true;
        settings.check.revision_rule = check.expected.size() == kWord                ? RevisionCheck::kLowWordEqual
                                       : check.type == ValidateType::kGreaterOrEqual ? RevisionCheck::kEqualOrGreater
                                                                                     : RevisionCheck::kEqual;
        break;
      case 0x0E:
        settings.check.serial = true;
        break;
      default:
        break;
    }
  }
}

template <class T>
void set_if_other(std::optional<T>& setting, const T& wanted, const T& of_device) {
  if (wanted != of_device) setting = wanted;
}

void recover_times(SlaveSettings& settings, const SlaveConfig& slave) {
  const StateTimeouts& of_device = settings.device.timeouts;
  set_if_other(settings.timeouts.preop, slave.timeouts.preop, of_device.preop);
  set_if_other(settings.timeouts.safeop_op, slave.timeouts.safeop_op, of_device.safeop_op);
  set_if_other(settings.timeouts.back_to_init, slave.timeouts.back_to_init, of_device.back_to_init);
  set_if_other(settings.timeouts.back_to_safeop, slave.timeouts.back_to_safeop, of_device.back_to_safeop);
  const auto writes = register_writes(slave.init_cmds);
  if (writes.reg_0400 != settings.device.reg_0400) settings.watchdog.divider = writes.reg_0400;
  if (writes.reg_0410 != settings.device.reg_0410) settings.watchdog.pdi = writes.reg_0410;
  if (writes.reg_0420 != settings.device.reg_0420) settings.watchdog.process_data = writes.reg_0420;
}

std::optional<std::uint16_t> default_size(const DeviceDescription& device, std::size_t manager) {
  return manager < device.sync_managers.size() ? device.sync_managers[manager].default_size : std::nullopt;
}

/// An address that EoE sets is a setting of its own; every other message is kept as it is.
void recover_messages(SlaveSettings& settings, const MailboxConfig& mailbox, const MessageProtocol& protocol,
                      const SlaveConfig& slave, FindingList& findings) {
  auto& messages = settings.*protocol.startup;
  messages.clear();
  for (const MailboxInitCmd& cmd : mailbox.*protocol.commands) {
    const auto ip = protocol.type == MailboxType::kEoe ? decode_ip_parameters(cmd.data, slave.station_address)
                                                       : std::optional<EoeSlaveSettings>();
    if (ip && cmd.enabled) {
      const bool enabled = settings.eoe.enabled;
      settings.eoe = *ip;
      settings.eoe.enabled = enabled;
    } else {
      messages.push_back(cmd);
    }
  }
  if (messages.empty() || speaks(settings.device, protocol)) return;
  findings.add("startup-lost", fig::count<"commands">(messages.size()),
               fig::text<"protocol">(std::string(protocol.name)));
  messages.clear();
}

void recover_mailbox(SlaveSettings& settings, const SlaveConfig& slave, EniDialect dialect, FindingList& findings) {
  if (!slave.mailbox) return;
  const MailboxConfig& mailbox = *slave.mailbox;
  if (default_size(settings.device, 0) != mailbox.send.length) settings.mailbox.out_size = mailbox.send.length;
  if (default_size(settings.device, 1) != mailbox.receive.length) settings.mailbox.in_size = mailbox.receive.length;
  settings.mailbox.state_bit = mailbox.status_bit_address.has_value();
  const std::uint32_t usual = dialect == EniDialect::kTwinCat ? 50 : 10;
  if (mailbox.poll_time_ms && *mailbox.poll_time_ms != usual) settings.mailbox.poll_time_ms = mailbox.poll_time_ms;
  settings.ams_net_id = mailbox.aoe_net_id;
  settings.eoe.enabled = !mailbox.eoe_disabled;
  for (const SoeInitCmd& cmd : mailbox.soe_commands) {
    settings.soe_startup.push_back(
        {cmd.transitions, cmd.drive_no, cmd.idn, cmd.data, cmd.fixed, cmd.enabled, cmd.timeout_ms, cmd.comment});
  }
  for (const auto& protocol : kMessageProtocols) recover_messages(settings, mailbox, protocol, slave, findings);
}

void recover_dc(SlaveSettings& settings, const SlaveConfig& slave, Nanoseconds cycle, FindingList& findings) {
  const auto choice = recovered_dc_settings(slave, settings.device, cycle);
  settings.dc = choice.settings;
  if (!choice.exact) {
    findings.add("dc-not-recovered", fig::text<"type">(settings.device.type),
                 fig::hex16<"activation">(dc_of(slave)->assign_activate));
  }
}

}  // namespace

SlaveSettings recovered_slave(const NetworkConfig& config, std::size_t position, const DeviceLookup& devices,
                              FindingList& findings) {
  const SlaveConfig& slave = config.slaves[position];
  const auto device = choose_device(slave, devices, config.cycle_time(), findings);
  SlaveSettings settings = default_slave(device, static_cast<std::uint16_t>(position));
  settings.name = slave.name;
  settings.station_address = slave.station_address;
  settings.alias = slave.alias;
  settings.device.identity.serial_no = slave.identity.serial_no;
  settings.previous = slave.previous;
  if (!settings.previous && position > 0) {
    settings.previous = PreviousPort{static_cast<std::uint16_t>(position - 1), 1};
  }
  plug_modules(settings, module_idents(slave));
  settings.startup.clear();
  settings.soe_startup.clear();
  recover_pdos(settings, slave);
  recover_checks(settings, sii_checks(slave.init_cmds));
  recover_times(settings, slave);
  recover_mailbox(settings, slave, dialect_of(config), findings);
  recover_dc(settings, slave, config.cycle_time(), findings);
  if (slave.hot_connect) {
    settings.hot_connect = slave.hot_connect->group;
    settings.alias = slave.hot_connect->alias().value_or(settings.alias);
  }
  if (slave.identification) {
    settings.check.device_id = static_cast<std::uint16_t>(slave.identification->value);
  }
  return settings;
}

}  // namespace syncline::recover
