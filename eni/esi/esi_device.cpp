// SPDX-License-Identifier: Apache-2.0
#include "eni/esi/esi_device.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/device_description.h"
#include "eni/xml/xml_text.h"
#include "protocol/sync_manager.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

FmmuUse read_fmmu_use(const Node& node) {
  const auto use = node.trimmed();
  if (use == "Outputs") return FmmuUse::kOutputs;
  if (use == "Inputs") return FmmuUse::kInputs;
  if (use == "MBoxState") return FmmuUse::kMailboxState;
  if (!use.empty()) node.warn(because("the use \"{use}\" is not known; the FMMU counts as free", use));
  return FmmuUse::kUnused;
}

void read_fmmus(const Node& device, DeviceDescription& description) {
  for (const Node& node : device.children("Fmmu")) {
    description.fmmus.push_back(read_fmmu_use(node));
    description.fmmu_options.push_back({.sync_manager = node.number<std::uint8_t>("Sm"),
                                        .sync_unit = node.number<std::uint8_t>("Su"),
                                        .op_only = node.boolean("OpOnly").value_or(false)});
  }
  if (std::ranges::count(description.fmmu_options, FmmuOptions{}) == std::ssize(description.fmmu_options)) {
    description.fmmu_options.clear();
  }
}

SyncManagerType type_of(const Node& node, std::uint8_t control) {
  const auto use = node.trimmed();
  if (const auto type = sync_manager_type(use)) return *type;
  if (use.empty()) return SyncManagerType::kUnused;
  // Some vendors write their own words; the control byte (0x0804) says mode and direction all the same.
  node.warn(because("the use \"{use}\" is not known; taken from the control byte 0x{control}", use,
                    fmt::format("{:02x}", control)));
  return sync_manager_type(SyncManager{.control = control});
}

SyncManagerDescription read_device_sync_manager(const Node& node) {
  SyncManagerDescription manager;
  manager.start_address = node.number<std::uint16_t>("StartAddress").value_or(0);
  manager.control_byte = node.number<std::uint8_t>("ControlByte").value_or(0);
  manager.min_size = node.number<std::uint16_t>("MinSize");
  manager.max_size = node.number<std::uint16_t>("MaxSize");
  manager.default_size = node.number<std::uint16_t>("DefaultSize");
  manager.enable = (node.number<std::uint8_t>("Enable").value_or(0) & 1) != 0;
  manager.is_virtual = node.boolean("Virtual").value_or(false);
  manager.op_only = node.boolean("OpOnly").value_or(false);
  manager.one_byte_mode = node.boolean("OneByteMode").value_or(false);
  manager.watchdog = node.boolean("Watchdog");
  manager.type = type_of(node, manager.control_byte);
  return manager;
}

SyncUnitDescription read_sync_unit(const Node& node) {
  return {.name = node.trimmed(),
          .separate_su = node.boolean("SeparateSu").value_or(false),
          .separate_frame = node.boolean("SeparateFrame").value_or(false),
          .depend_on_input_state = node.boolean("DependOnInputState").value_or(false),
          .frame_repeat_support = node.boolean("FrameRepeatSupport").value_or(false)};
}

void read_memory(const Node& device, DeviceDescription& description) {
  read_fmmus(device, description);
  for (const Node& sm : device.children("Sm")) description.sync_managers.push_back(read_device_sync_manager(sm));
  for (const Node& su : device.children("Su")) description.sync_units.push_back(read_sync_unit(su));
  const Node esc = device.child("ESC");
  description.reg_0108 = esc.child_number<std::uint16_t>("Reg0108");
  description.reg_0400 = esc.child_number<std::uint16_t>("Reg0400");
  description.reg_0410 = esc.child_number<std::uint16_t>("Reg0410");
  description.reg_0420 = esc.child_number<std::uint16_t>("Reg0420");
}

void read_group_name(const std::vector<DeviceGroup>& groups, DeviceDescription& description) {
  const auto group = std::ranges::find(groups, description.group_type, &DeviceGroup::type);
  if (group != groups.end()) description.group_name = group->name;
}

void read_slots_and_modules(const Node& slots, const EsiSurroundings& surroundings, DeviceDescription& description) {
  if (!slots) return;
  description.slots = read_slots(slots);
  description.modules = modules_for(*description.slots, surroundings.vendor.id, surroundings.modules);
  for (const SlotDescription& slot : description.slots->slots) {
    for (const ModuleIdent& allowed : slot.modules) {
      if (description.module(allowed.ident) != nullptr) continue;
      slots.warn(because("no file describes the module 0x{module} of the slot \"{slot}\"",
                         fmt::format("{:08x}", allowed.ident), slot.name));
    }
  }
}

/// "Not together with itself" says nothing; some files do.
void drop_self_exclusion(const Node& device, const char* tag, std::vector<Pdo>& pdos) {
  const auto nodes = device.children(tag);
  for (std::size_t i = 0; i < pdos.size() && i < nodes.size(); ++i) {
    if (std::erase(pdos[i].exclude, pdos[i].index) > 0) {
      nodes[i].warn(
          because("the PDO 0x{index} excludes itself; that is left out", fmt::format("{:04x}", pdos[i].index)));
    }
  }
}

/// An empty element is none, unless there are SyncManagers for a mailbox.
bool has_mailbox(const Node& mailbox, const DeviceDescription& device) {
  if (!mailbox) return false;
  return mailbox.has_children() || std::ranges::any_of(device.sync_managers, [](const SyncManagerDescription& manager) {
           return manager.type == SyncManagerType::kMailboxOut || manager.type == SyncManagerType::kMailboxIn;
         });
}

}  // namespace

DeviceDescription read_device(const Node& node, const EsiSurroundings& surroundings) {
  if (!node) return {};
  DeviceDescription device;
  device.identity.vendor_id = surroundings.vendor.id;
  device.vendor_name = surroundings.vendor.name;
  device.source = node.reading().file();
  read_identity(node, device);
  read_group_name(surroundings.groups, device);
  read_memory(node, device);
  for (const Node& pdo : node.children("RxPdo")) device.rx_pdos.push_back(read_pdo(pdo, surroundings.pdo_templates));
  for (const Node& pdo : node.children("TxPdo")) device.tx_pdos.push_back(read_pdo(pdo, surroundings.pdo_templates));
  const Node mailbox = node.child("Mailbox");
  if (surroundings.written_by_us) {
    if (mailbox) device.mailbox = read_mailbox(node, mailbox);
  } else {
    check_pdo_indices(node, device.rx_pdos, device.tx_pdos);
    drop_self_exclusion(node, "RxPdo", device.rx_pdos);
    drop_self_exclusion(node, "TxPdo", device.tx_pdos);
    if (has_mailbox(mailbox, device)) device.mailbox = read_mailbox(node, mailbox);
  }
  if (const Node dc = node.child("Dc")) device.dc = read_dc(dc);
  read_info(node, device);
  device.eeprom = read_eeprom(node.child("Eeprom"));
  auto profiles = read_profiles(node, surroundings.side_files);
  device.profiles = std::move(profiles.profiles);
  device.dictionary = std::move(profiles.dictionary);
  device.enums = std::move(profiles.enums);
  read_slots_and_modules(node.child("Slots"), surroundings, device);
  return device;
}

DeviceDescription read_device(const Node& node, const EsiVendor& vendor, FileWarnings& warnings) {
  if (!node) return {};
  Reading reading(node.reading().file(), warnings);
  auto device = read_device(node.with(reading), EsiSurroundings{.vendor = vendor});
  if (!reading.ok()) node.reading().fail(*reading.error());
  return device;
}

}  // namespace syncline::eni
