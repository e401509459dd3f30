// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/dc_description.h"
#include "config/esi_text.h"
#include "config/identity.h"
#include "config/mailbox_description.h"
#include "config/module_description.h"
#include "config/object_description.h"
#include "config/pdo_description.h"
#include "config/state_timeouts.h"
#include "config/sync_manager_description.h"
#include "config/sync_unit.h"

/// What an ESI file (ETG.2000) or a slave's SII says about a device: plain values, no XML.
namespace syncline {

enum class FmmuUse : std::uint8_t { kUnused = 0, kOutputs = 1, kInputs = 2, kMailboxState = 3 };

/// Attributes of an Fmmu element.
struct FmmuOptions {
  std::optional<std::uint8_t> sync_manager{};  // Sm
  std::optional<std::uint8_t> sync_unit{};     // Su
  bool op_only = false;
  bool operator==(const FmmuOptions&) const = default;
};

/// HideType, AlternativeType, SubDevice: another device of the vendor.
struct DeviceReference {
  std::string type{};
  std::optional<std::uint32_t> product_code{};  // empty: the same product
  std::optional<std::uint32_t> revision_no{};
  std::string product_revision{};  // @ProductRevision, older files: "EL1002-0000-0016"
  bool operator==(const DeviceReference&) const = default;
};

/// Info/Port.
struct PortDescription {
  std::string type{};  // MII, EBUS, NONE
  std::string connector{}, label{};
  std::optional<std::int32_t> rx_delay{}, tx_delay{};  // 100 ps
  bool operator==(const PortDescription&) const = default;
};

/// Info/StateMachine/Behavior: states that the device may start up in, and how it leaves SAFEOP.
struct StartBehavior {
  bool to_init = false, to_preop = false, to_safeop = false, to_safeop_no_sync = false;
  bool operator==(const StartBehavior&) const = default;
};

struct EepromCategory {
  std::uint16_t number = 0;
  std::vector<std::uint8_t> data{};
  bool operator==(const EepromCategory&) const = default;
};

struct EepromDescription {
  std::uint32_t byte_size = 2048;
  std::vector<std::uint8_t> config_data;     // first 14 bytes of the SII
  std::vector<std::uint8_t> boot_strap;      // 8 bytes: out start, out length, in start, in length
  std::vector<std::uint8_t> image{};         // Data: the whole content, where the ESI gives that
  std::vector<EepromCategory> categories{};  // the vendor's own
  bool assign_to_pdi = false;
  bool operator==(const EepromDescription&) const = default;
};

struct DeviceDescription {
  Identity identity;
  std::string vendor_name;
  std::string group_type;
  std::string type;          // ESI Type text, e.g. "EL2002"
  std::string name;          // display name
  std::string physics;       // "YY", "YKKY"
  bool use_lrd_lwr = false;  // Type@UseLrdLwr
  std::vector<FmmuUse> fmmus;
  std::vector<SyncManagerDescription> sync_managers;
  std::vector<Pdo> rx_pdos, tx_pdos;
  std::optional<MailboxDescription> mailbox;
  std::optional<DcDescription> dc;
  StateTimeouts timeouts;
  EepromDescription eeprom;
  std::optional<std::uint16_t> reg_0400, reg_0410, reg_0420;
  std::vector<ChannelProfile> profiles;
  std::vector<ObjectDescription> dictionary;
  std::vector<EnumDescription> enums{};
  std::vector<LocalizedText> names{};  // in all languages; `name` is the reader's choice
  std::string group_name{};
  EsiImage image{};
  bool invisible = false;  // not offered by catalogues
  std::vector<DeviceReference> hides{}, alternatives{}, sub_devices{};
  std::optional<bool> check_product_code{}, check_serial_no{};  // empty: ESI is silent
  std::optional<RevisionCheck> check_revision{};
  std::vector<FmmuOptions> fmmu_options{};  // empty or one for each of `fmmus`
  std::vector<SyncUnitDescription> sync_units{};
  std::optional<SlotsDescription> slots{};
  std::vector<ModuleDescription> modules{};  // those that fit a slot, file order
  std::optional<int> module_pdo_group{};     // Type@ModulePdoGroup: place of the device's own PDOs
  bool download_module_list = false;
  bool identification_reg134 = false;                 // ID switch is read in register 0x0134
  std::optional<std::uint16_t> identification_ado{};  // or in this register
  std::optional<std::int32_t> ebus_current_ma{};      // negative: supplies
  std::vector<PortDescription> ports{};
  StartBehavior behavior{};
  std::optional<std::uint32_t> dpram_size{};  // bytes
  std::optional<std::uint8_t> sync_manager_count{}, fmmu_count{};
  std::optional<std::uint16_t> reg_0108{};
  std::string source;  // file the description came from, or "SII"
  bool operator==(const DeviceDescription&) const = default;

  /// ESI Eeprom/ConfigData byte 1 bit 0: AL status mirrors AL control, no error acknowledge.
  [[nodiscard]] bool device_emulation() const {
    return eeprom.config_data.size() > 1 && (eeprom.config_data[1] & 0x01) != 0;
  }
  [[nodiscard]] const std::vector<Pdo>& pdos(PdoDirection direction) const {
    return direction == PdoDirection::kRx ? rx_pdos : tx_pdos;
  }
  /// The module with that ident; null when no slot takes it.
  [[nodiscard]] const ModuleDescription* module(std::uint32_t ident) const;
};

}  // namespace syncline
