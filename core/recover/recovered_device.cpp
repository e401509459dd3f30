// SPDX-License-Identifier: Apache-2.0
#include "recover/recovered_device.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/slave_config.h"
#include "recover/recovered_dc.h"
#include "recover/register_writes.h"
#include "support/byte_order.h"

namespace syncline::recover {
namespace {

SyncManagerDescription mailbox_manager(SyncManagerType type, const MailboxChannel& channel) {
  SyncManagerDescription description;
  description.type = type;
  description.start_address = channel.start;
  description.default_size = channel.length;
  description.control_byte = type == SyncManagerType::kMailboxOut ? 0x26 : 0x22;
  description.enable = true;
  return description;
}

/// Start, length and control as they are written count more than what is described.
void add_written(DeviceDescription& device, const RegisterWrites& writes, const SlaveConfig& slave) {
  for (const auto& [number, written] : writes.sync_managers) {
    if (number >= device.sync_managers.size()) device.sync_managers.resize(number + 1U);
    auto& description = device.sync_managers[number];
    const bool described =
        std::ranges::find(slave.sync_managers, number, &ConfiguredSyncManager::number) != slave.sync_managers.end();
    if (described || !written.enabled()) continue;
    if (description.type == SyncManagerType::kUnused) {
      description.type = sync_manager_type(written);
      description.start_address = written.start;
      description.default_size = written.length;
    }
    description.control_byte = written.control;
    description.enable = true;
  }
}

void add_sync_managers(DeviceDescription& device, const SlaveConfig& slave, const RegisterWrites& writes) {
  if (slave.mailbox && slave.mailbox->send.length > 0) {
    device.sync_managers = {mailbox_manager(SyncManagerType::kMailboxOut, slave.mailbox->send),
                            mailbox_manager(SyncManagerType::kMailboxIn, slave.mailbox->receive)};
  }
  for (const auto& manager : slave.sync_managers) {
    if (manager.number >= device.sync_managers.size()) device.sync_managers.resize(manager.number + 1U);
    device.sync_managers[manager.number] = manager.description;
  }
  add_written(device, writes, slave);
}

void add_fmmus(DeviceDescription& device, const SlaveConfig& slave, const RegisterWrites& writes) {
  constexpr std::uint16_t kMailboxStatus = 0x080D;
  for (const auto& [number, fmmu] : writes.fmmus) {
    if (fmmu.length == 0 && !fmmu.active) continue;
    if (number >= device.fmmus.size()) device.fmmus.resize(number + 1U, FmmuUse::kUnused);
    device.fmmus[number] = fmmu.physical_start == kMailboxStatus ? FmmuUse::kMailboxState
                           : fmmu.write                          ? FmmuUse::kOutputs
                                                                 : FmmuUse::kInputs;
  }
  if (!device.fmmus.empty()) return;
  if (slave.send) device.fmmus.push_back(FmmuUse::kOutputs);
  if (slave.receive) device.fmmus.push_back(FmmuUse::kInputs);
  if (slave.mailbox && slave.mailbox->status_bit_address) device.fmmus.push_back(FmmuUse::kMailboxState);
}

/// Indexes that the start-up commands assign to a SyncManager (0x1C10 + number), one by one or all at once.
std::vector<std::uint16_t> commanded_pdos(const SlaveConfig& slave, std::uint8_t manager) {
  std::vector<std::uint16_t> indexes;
  if (!slave.mailbox) return indexes;
  for (const auto& [command, ccs] : slave.mailbox->coe_commands) {
    if (command.index != 0x1C10 + manager || !command.enabled) continue;
    const std::span<const std::uint8_t> data(command.data);
    if (command.complete_access && command.sub_index == 0 && data.size() >= 4) {
      indexes.clear();
      for (std::size_t at = 2; at + 2 <= data.size(); at += 2)
        indexes.push_back(load_le<std::uint16_t>(data.subspan(at)));
    } else if (command.sub_index > 0 && data.size() == 2) {
      indexes.push_back(load_le<std::uint16_t>(data));
    }
  }
  return indexes;
}

/// Process data whose meaning nobody tells: padding of the right size, in PDOs that a device can describe. Which of
/// several PDOs has which part is unknown; the first takes all.
std::vector<Pdo> nameless_pdos(PdoDirection direction, std::uint8_t manager, std::uint32_t bits,
                               const std::vector<std::uint16_t>& indexes) {
  constexpr std::uint32_t kMostBits = 248, kMostEntries = 32;
  const auto first = static_cast<std::uint16_t>((direction == PdoDirection::kRx ? 0x1600 : 0x1A00) + 0x10U * manager);
  std::vector<Pdo> pdos;
  while (bits > 0 || pdos.size() < indexes.size()) {
    Pdo pdo;
    pdo.index = pdos.size() < indexes.size() ? indexes[pdos.size()] : static_cast<std::uint16_t>(first + pdos.size());
    pdo.name = fmt::format("SM {}", manager);
    pdo.sync_manager = manager;
    pdo.fixed = true;
    while (bits > 0 && pdo.entries.size() < kMostEntries) {
      PdoEntry entry;
      entry.bit_length = static_cast<std::uint16_t>(std::min(bits, kMostBits));
      bits -= entry.bit_length;
      pdo.entries.push_back(std::move(entry));
    }
    pdos.push_back(std::move(pdo));
  }
  return pdos;
}

std::vector<Pdo>& pdos_of(DeviceDescription& device, PdoDirection direction) {
  return direction == PdoDirection::kRx ? device.rx_pdos : device.tx_pdos;
}

void add_pdos(DeviceDescription& device, const SlaveConfig& slave, const RegisterWrites& writes) {
  for (const auto& [direction, pdo] : slave.pdos) {
    auto& added = pdos_of(device, direction).emplace_back(pdo);
    for (const auto& manager : slave.sync_managers) {
      if (std::ranges::count(manager.pdos, pdo.index) > 0) added.sync_manager = manager.number;
    }
  }
  for (const auto& [manager, written] : writes.sync_managers) {
    const std::uint8_t number = manager;  // clang 14 captures no structured bindings
    const auto type = device.sync_managers[number].type;
    if (!written.enabled() || written.length == 0) continue;
    if (type != SyncManagerType::kOutputs && type != SyncManagerType::kInputs) continue;
    const auto direction = type == SyncManagerType::kOutputs ? PdoDirection::kRx : PdoDirection::kTx;
    auto& pdos = pdos_of(device, direction);
    const bool named = std::ranges::any_of(pdos, [&](const Pdo& pdo) { return pdo.sync_manager == number; });
    if (named) continue;
    const auto range = direction == PdoDirection::kRx ? slave.send : slave.receive;
    const bool bits_fit = range && (std::uint64_t{range->bit_length} + 7) / 8 == written.length;
    auto nameless = nameless_pdos(direction, number, bits_fit ? range->bit_length : 8U * written.length,
                                  commanded_pdos(slave, number));
    std::ranges::move(nameless, std::back_inserter(pdos));
  }
}

bool maps(const SlaveConfig& slave, std::uint16_t index) {
  return std::ranges::any_of(slave.pdos, [&](const ConfiguredPdo& configured) {
    return configured.pdo.index == index && !configured.pdo.fixed;
  });
}

void add_mailbox(DeviceDescription& device, const SlaveConfig& slave) {
  if (!slave.mailbox) return;
  const MailboxConfig& mailbox = *slave.mailbox;
  auto& description = device.mailbox.emplace();
  description.data_link_layer = mailbox.data_link_layer;
  description.aoe = mailbox.aoe;
  description.eoe = mailbox.eoe;
  description.foe = mailbox.foe;
  description.soe = mailbox.soe;
  description.voe = mailbox.voe;
  description.request_timeout_ms = mailbox.timeouts.request_ms;
  description.response_timeout_ms = mailbox.timeouts.response_ms;
  device.profiles = mailbox.profiles;
  if (mailbox.coe || !mailbox.coe_commands.empty()) {
    auto& coe = description.coe.emplace();
    for (const auto& cmd : mailbox.coe_commands) {
      const bool assigns = cmd.command.index >= 0x1C10 && cmd.command.index <= 0x1C2F;
      const bool mapping = maps(slave, cmd.command.index);
      coe.pdo_assign = coe.pdo_assign || assigns;
      coe.pdo_config = coe.pdo_config || mapping;
      coe.complete_access = coe.complete_access || (cmd.command.complete_access && (assigns || mapping));
    }
  }
  if (mailbox.bootstrap_send && mailbox.bootstrap_receive) {
    for (const std::uint16_t word : {mailbox.bootstrap_send->start, mailbox.bootstrap_send->length,
                                     mailbox.bootstrap_receive->start, mailbox.bootstrap_receive->length}) {
      device.eeprom.boot_strap.push_back(static_cast<std::uint8_t>(word & 0xFF));
      device.eeprom.boot_strap.push_back(static_cast<std::uint8_t>(word >> 8));
    }
  }
}

/// Words 0 to 6 of the SII: a PDI without (digital I/O) or with (SPI) a controller, and the DC unit.
std::vector<std::uint8_t> config_data(const RegisterWrites& writes, const SlaveConfig& slave) {
  constexpr std::uint8_t kDigitalIo = 0x04, kSpi = 0x05, kEmulation = 0x01, kDcUnit = 0x0C;
  // Without a controller there is no mailbox either, whatever a tool leaves out of its requests.
  const bool emulation = !slave.mailbox && writes.state_request && (*writes.state_request & kAlErrorFlag) == 0;
  std::vector<std::uint8_t> data(14);
  data[0] = emulation ? kDigitalIo : kSpi;
  data[1] = static_cast<std::uint8_t>((emulation ? kEmulation : 0U) | (slave.dc ? kDcUnit : 0U));
  std::copy_n(writes.pdi.begin(), std::min<std::size_t>(writes.pdi.size(), 2), data.begin());
  return data;
}

std::string between(const std::string& text, char open, char close) {
  const auto begin = text.rfind(open);
  const auto end = text.rfind(close);
  if (begin == std::string::npos || end == std::string::npos || end < begin + 2) return {};
  auto inner = text.substr(begin + 1, end - begin - 1);
  inner.erase(inner.find_last_not_of(' ') + 1);
  inner.erase(0, inner.find_first_not_of(' '));
  return inner;
}

}  // namespace

std::string device_type(const SlaveConfig& slave) {
  for (auto type : {between(slave.name, '[', ']'), between(slave.name, '(', ')')}) {
    if (!type.empty()) return type;
  }
  // "EL2008-0000-0018": type, low word and high word of the revision.
  constexpr std::size_t kRevisionText = 10;
  if (slave.product_revision.size() > kRevisionText) {
    return slave.product_revision.substr(0, slave.product_revision.size() - kRevisionText);
  }
  return slave.name;
}

std::vector<std::uint16_t> assigned_pdos(const SlaveConfig& slave, PdoDirection direction) {
  std::vector<std::uint16_t> listed, marked;
  const auto known = [&](std::uint16_t index) {
    return std::ranges::any_of(slave.pdos, [&](const ConfiguredPdo& configured) {
      return configured.direction == direction && configured.pdo.index == index;
    });
  };
  for (const auto& manager : slave.sync_managers) {
    std::ranges::copy_if(manager.pdos, std::back_inserter(listed), known);
  }
  for (const auto& configured : slave.pdos) {
    if (configured.direction == direction && configured.pdo.sync_manager) marked.push_back(configured.pdo.index);
  }
  if (!listed.empty() || !marked.empty() || !slave.pdos.empty()) return listed.empty() ? marked : listed;
  // Nothing is described; what the start-up commands assign is.
  const auto wanted = direction == PdoDirection::kRx ? SyncManagerType::kOutputs : SyncManagerType::kInputs;
  for (const auto& [number, written] : register_writes(slave.init_cmds).sync_managers) {
    if (sync_manager_type(written) != wanted) continue;
    std::ranges::copy(commanded_pdos(slave, number), std::back_inserter(marked));
  }
  return marked;
}

DeviceDescription recovered_device(const SlaveConfig& slave, Nanoseconds bus_cycle) {
  const auto writes = register_writes(slave.init_cmds);
  DeviceDescription device;
  device.identity = slave.identity;
  device.type = device_type(slave);
  device.name = device.type;
  device.physics = slave.physics.empty() ? "YY" : slave.physics;
  device.source = "ENI";
  add_sync_managers(device, slave, writes);
  add_fmmus(device, slave, writes);
  add_pdos(device, slave, writes);
  add_mailbox(device, slave);
  device.dc = recovered_dc(slave, bus_cycle);
  device.timeouts = slave.timeouts;
  device.eeprom.config_data = config_data(writes, slave);
  device.reg_0400 = writes.reg_0400;
  device.reg_0410 = writes.reg_0410;
  device.reg_0420 = writes.reg_0420;
  return device;
}

}  // namespace syncline::recover
