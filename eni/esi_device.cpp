// SPDX-License-Identifier: Apache-2.0
#include "eni/esi_device.h"

#include <fmt/format.h>

#include <algorithm>

#include "eni/xml_text.h"

namespace syncline::eni {
namespace {

class DeviceReader {
 public:
  DeviceReader(const Node& node, const EsiVendor& vendor, FileWarnings& warnings)
      : node_(node), warnings_(warnings) {
    device_.identity.vendor_id = vendor.id;
    device_.vendor_name = vendor.name;
    device_.source = node.reading().file();
  }

  DeviceDescription read() {
    read_identity();
    read_memory();
    for (const Node& pdo : node_.children("RxPdo")) device_.rx_pdos.push_back(read_pdo(pdo));
    for (const Node& pdo : node_.children("TxPdo")) device_.tx_pdos.push_back(read_pdo(pdo));
    if (const Node mailbox = node_.child("Mailbox")) device_.mailbox = read_mailbox(node_, mailbox);
    if (const Node dc = node_.child("Dc")) device_.dc = read_dc(dc);
    read_timeouts();
    read_eeprom();
    read_profiles();
    return std::move(device_);
  }

 private:
  void read_identity() {
    const Node type = node_.required("Type");
    device_.type = type.text();  // not trimmed: configurators build slave names from it as it stands
    device_.identity.product_code = type.number<std::uint32_t>("ProductCode").value_or(0);
    device_.identity.revision_no = type.number<std::uint32_t>("RevisionNo").value_or(0);
    device_.identity.serial_no = type.number<std::uint32_t>("SerialNo").value_or(0);
    device_.check_revision_low_word = type.attribute("CheckRevisionNo") == "LW_EQ";
    device_.use_lrd_lwr = type.boolean("UseLrdLwr").value_or(false);
    device_.name = node_.child("Name") ? node_.localized("Name").trimmed() : std::string(trim(device_.type));
    device_.group_type = node_.child("GroupType").trimmed();
    device_.physics = node_.attribute("Physics");
  }

  void read_memory() {
    for (const Node& fmmu : node_.children("Fmmu")) device_.fmmus.push_back(read_fmmu(fmmu));
    for (const Node& sm : node_.children("Sm")) device_.sync_managers.push_back(read_sync_manager(sm));
    const Node esc = node_.child("ESC");
    device_.reg_0400 = esc.child_number<std::uint16_t>("Reg0400");
    device_.reg_0410 = esc.child_number<std::uint16_t>("Reg0410");
    device_.reg_0420 = esc.child_number<std::uint16_t>("Reg0420");
  }

  FmmuUse read_fmmu(const Node& node) {
    const auto use = node.trimmed();
    if (use == "Outputs") return FmmuUse::kOutputs;
    if (use == "Inputs") return FmmuUse::kInputs;
    if (use == "MBoxState") return FmmuUse::kMailboxState;
    if (!use.empty()) warn(node, fmt::format("the use \"{}\" is not known; the FMMU counts as free", use));
    return FmmuUse::kUnused;
  }

  SyncManagerDescription read_sync_manager(const Node& node) {
    SyncManagerDescription manager;
    manager.start_address = node.number<std::uint16_t>("StartAddress").value_or(0);
    manager.control_byte = node.number<std::uint8_t>("ControlByte").value_or(0);
    manager.min_size = node.number<std::uint16_t>("MinSize");
    manager.max_size = node.number<std::uint16_t>("MaxSize");
    manager.default_size = node.number<std::uint16_t>("DefaultSize");
    manager.enable = (node.number<std::uint8_t>("Enable").value_or(0) & 1) != 0;
    manager.is_virtual = node.boolean("Virtual").value_or(false);
    manager.op_only = node.boolean("OpOnly").value_or(false);
    manager.type = sync_manager_type(node, manager.control_byte);
    return manager;
  }

  SyncManagerType sync_manager_type(const Node& node, std::uint8_t control) {
    const auto use = node.trimmed();
    if (use == "MBoxOut") return SyncManagerType::kMailboxOut;
    if (use == "MBoxIn") return SyncManagerType::kMailboxIn;
    if (use == "Outputs") return SyncManagerType::kOutputs;
    if (use == "Inputs") return SyncManagerType::kInputs;
    if (use.empty()) return SyncManagerType::kUnused;
    // Some vendors write their own words; the control byte (0x0804) says mode and direction all the same.
    const bool mailbox = (control & 0x03) == 0x02;
    const bool written_by_master = (control & 0x0C) == 0x04;
    warn(node, fmt::format("the use \"{}\" is not known; taken from the control byte 0x{:02x}", use, control));
    if (mailbox) return written_by_master ? SyncManagerType::kMailboxOut : SyncManagerType::kMailboxIn;
    return written_by_master ? SyncManagerType::kOutputs : SyncManagerType::kInputs;
  }

  void read_timeouts() {
    const Node timeout = node_.child("Info").child("StateMachine").child("Timeout");
    auto& t = device_.timeouts;
    t.preop = timeout.child_number<std::uint32_t>("PreopTimeout").value_or(t.preop);
    t.safeop_op = timeout.child_number<std::uint32_t>("SafeopOpTimeout").value_or(t.safeop_op);
    t.back_to_init = timeout.child_number<std::uint32_t>("BackToInitTimeout").value_or(t.back_to_init);
    t.back_to_safeop = timeout.child_number<std::uint32_t>("BackToSafeopTimeout").value_or(t.back_to_safeop);
  }

  void read_eeprom() {
    constexpr std::size_t kConfigBytes = 14, kBootStrapStart = 0x14 * 2, kBootStrapBytes = 8;
    const Node node = node_.child("Eeprom");
    auto& eeprom = device_.eeprom;
    if (const Node data = node.child("Data")) {  // the whole image instead of its parts
      const auto image = data.bytes();
      const auto part = [&image](std::size_t from, std::size_t count) {
        const auto begin = std::min(from, image.size()), end = std::min(from + count, image.size());
        return std::vector<std::uint8_t>(image.begin() + static_cast<std::ptrdiff_t>(begin),
                                         image.begin() + static_cast<std::ptrdiff_t>(end));
      };
      eeprom.byte_size = static_cast<std::uint32_t>(image.size());
      eeprom.config_data = part(0, kConfigBytes);
      eeprom.boot_strap = part(kBootStrapStart, kBootStrapBytes);
      return;
    }
    eeprom.byte_size = node.child_number<std::uint32_t>("ByteSize").value_or(eeprom.byte_size);
    eeprom.config_data = node.child("ConfigData").bytes();
    eeprom.boot_strap = node.child("BootStrap").bytes();
  }

  void read_profiles() {
    for (const Node& profile : node_.children("Profile")) {
      for (const Node& channel : profile.children("ChannelInfo")) add_profile(channel);
      add_profile(profile);
      auto objects = read_dictionary(profile, warnings_);
      std::ranges::move(objects, std::back_inserter(device_.dictionary));
    }
  }

  /// ProfileNo and AddInfo stand in ChannelInfo, in older files directly in Profile.
  void add_profile(const Node& node) {
    if (!node.child("ProfileNo")) return;
    device_.profiles.push_back({.profile_no = node.child("ProfileNo").number<std::uint32_t>(),
                                .add_info = node.child_number<std::uint32_t>("AddInfo").value_or(0)});
  }

  void warn(const Node& node, std::string text) {
    warnings_.push_back({node.reading().file(), node.line(), std::string(node.name()), std::move(text)});
  }

  Node node_;
  FileWarnings& warnings_;
  DeviceDescription device_;
};

}  // namespace

DeviceDescription read_device(const Node& device, const EsiVendor& vendor, FileWarnings& warnings) {
  return DeviceReader(device, vendor, warnings).read();
}

}  // namespace syncline::eni
