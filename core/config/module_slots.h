// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "config/pdo_description.h"
#include "support/result.h"

/// Modular devices: places for modules, and what a module becomes at its place.
namespace syncline {

struct DeviceDescription;
struct ModuleDescription;
struct SlaveSettings;
struct SlotDescription;

/// One place for a module. A slot of the ESI that may occur several times has as many places in a row.
struct SlotPlace {
  std::uint16_t number = 0;  // from 0, over all slots
  const SlotDescription* slot = nullptr;
  bool demanded = false;  // MinInstances: a module has to be there
  /// What PDO and object indices of a module move by: the increments of all places before this one, and those of its
  /// slot group.
  std::uint16_t pdo_offset = 0, index_offset = 0, group_pdo_offset = 0, group_index_offset = 0;
};

/// At most MaxSlotCount places, and never more than 1024, whatever the ESI says.
[[nodiscard]] std::vector<SlotPlace> slot_places(const DeviceDescription& device);

[[nodiscard]] bool accepts(const SlotDescription& slot, const ModuleDescription& module);

/// The module with the indices that it has at this place.
[[nodiscard]] ModuleDescription module_at(const ModuleDescription& module, const SlotPlace& place);

/// The module plugged at a place; empty when there is none.
[[nodiscard]] std::optional<std::uint32_t> plugged_module(const SlaveSettings& slave, std::uint16_t place);

/// Plugs a module (or pulls the one that is there): its PDOs join the assignment and its init commands the start-up
/// list, those of the module before leave them. kBadValue when there is no such place or the module does not fit.
[[nodiscard]] Status plug_module(SlaveSettings& slave, std::uint16_t place, std::optional<std::uint32_t> ident);

/// The modules that the ESI marks as default or demands, for a slave that has none yet.
void plug_default_modules(SlaveSettings& slave);

/// PDOs of the device and of its modules.
[[nodiscard]] std::vector<Pdo> pdos_of(const SlaveSettings& slave, PdoDirection direction);
[[nodiscard]] std::optional<Pdo> pdo_of(const SlaveSettings& slave, std::uint32_t index);

/// The device as the bus sees it: with the PDOs and init commands of its modules beside its own.
[[nodiscard]] DeviceDescription device_with_modules(const SlaveSettings& slave);

}  // namespace syncline
