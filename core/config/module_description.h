// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/esi_text.h"
#include "config/mailbox_description.h"
#include "config/object_description.h"
#include "config/pdo_description.h"

/// Modular devices (ETG.5001, ETG.2000 Slots and Modules): which module fits which slot, and what it brings.
namespace syncline {

/// How far one slot's (or slot group's) PDOs and objects lie from the next one's.
struct SlotIncrements {
  std::optional<std::uint16_t> slot_pdo{}, slot_group_pdo{};      // SlotPdoIncrement, SlotGroupPdoIncrement
  std::optional<std::uint16_t> slot_index{}, slot_group_index{};  // SlotIndexIncrement, SlotGroupIndexIncrement
  bool operator==(const SlotIncrements&) const = default;
};

struct ModuleIdent {
  std::uint32_t ident = 0;
  bool is_default = false;  // is plugged in a new project
  bool operator==(const ModuleIdent&) const = default;
};

struct ModuleClass {
  std::string name{};  // Class: what Module/Type@ModuleClass says
  std::optional<std::uint32_t> vendor_id{};
  std::string display_name{};
  bool operator==(const ModuleClass&) const = default;
};

/// Slots/Slot: stands for MinInstances..MaxInstances places in a row.
struct SlotDescription {
  std::string name{};
  std::uint16_t min_instances = 0;
  std::uint16_t max_instances = 0;
  std::vector<ModuleIdent> modules{};  // allowed by ident
  std::vector<ModuleClass> classes{};  // or allowed by class
  std::optional<std::uint16_t> slot_group{};
  SlotIncrements increments{};  // instead of those of all slots
  std::optional<int> mdp_channel{};
  EsiImage image{};
  bool operator==(const SlotDescription&) const = default;
  /// The module that a new project plugs: the one marked as default, else the first when at least one is demanded.
  [[nodiscard]] std::optional<std::uint32_t> default_module() const;
};

/// Slots/ModulePdoGroup: modules of that number map behind `alignment` bytes; the PDO numbers fill the gap.
struct ModulePdoGroup {
  std::string name{};
  std::uint16_t alignment = 0;  // bytes; 0 = none
  std::optional<std::uint16_t> rx_pdo{}, tx_pdo{};
  bool operator==(const ModulePdoGroup&) const = default;
};

enum class ModuleIdentification : std::uint8_t { kModuleIdent, kIdentityObject };

struct SlotsDescription {
  std::vector<SlotDescription> slots{};
  std::vector<ModulePdoGroup> pdo_groups{};  // number 0 is the device itself, Type@ModulePdoGroup counts them
  std::optional<std::uint16_t> max_slot_count{}, max_slot_group_count{};
  SlotIncrements increments{};
  ModuleIdentification identify_by = ModuleIdentification::kModuleIdent;
  std::optional<std::uint16_t> mdp_channel_count{};
  bool download_ident_list = false;   // 0xF030 is written with what is plugged
  std::string download_transition{};  // of that write; empty: PS
  bool operator==(const SlotsDescription&) const = default;
};

struct ModuleDescription {
  std::uint32_t ident = 0;
  std::string type{};
  std::string name{};
  std::vector<LocalizedText> names{};
  std::string module_class{};
  std::optional<int> pdo_group{};         // Type@ModulePdoGroup
  std::vector<Pdo> rx_pdos{}, tx_pdos{};  // indices of slot 0; see Pdo::depend_on_slot
  std::optional<CoeDescription> coe{};    // its init commands, also indices of slot 0
  std::vector<ChannelProfile> profiles{};
  std::vector<ObjectDescription> dictionary{};
  std::vector<EnumDescription> enums{};
  std::string dc_op_mode{};  // DcOpModeName: mode of the device that it demands
  EsiImage image{};
  bool operator==(const ModuleDescription&) const = default;
};

}  // namespace syncline
