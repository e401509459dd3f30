// SPDX-License-Identifier: Apache-2.0
#include "compile/module_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "config/module_slots.h"

namespace syncline::compiler {
namespace {

std::string key_of(std::uint16_t place) { return fmt::format("module.{}", place); }

void check_plugged(FindingList& findings, const SlavePlan& slave, const std::vector<SlotPlace>& places) {
  const SlaveSettings& settings = *slave.settings;
  for (const PluggedModule& plugged : settings.modules) {
    const ModuleDescription* module = settings.device.module(plugged.ident);
    if (plugged.slot >= places.size()) {
      findings.error("",
                     fmt::format("A module is plugged into place {}; the device has {}.", plugged.slot, places.size()));
    } else if (module == nullptr || !accepts(*places[plugged.slot].slot, *module)) {
      findings.error(key_of(plugged.slot),
                     fmt::format("Module 0x{:08X} does not fit into place {}. Choose another, or none.", plugged.ident,
                                 plugged.slot));
    } else if (!module->dc_op_mode.empty() && module->dc_op_mode != settings.dc.op_mode) {
      findings.warning("dc.op_mode", fmt::format("Module {} in place {} demands the operation mode {}.", module->type,
                                                 plugged.slot, module->dc_op_mode));
    }
  }
}

void check_empty(FindingList& findings, const SlavePlan& slave, const std::vector<SlotPlace>& places) {
  for (const SlotPlace& place : places) {
    if (place.demanded && !plugged_module(*slave.settings, place.number)) {
      findings.error(key_of(place.number), fmt::format("Place {}{}{} must have a module.", place.number,
                                                       place.slot->name.empty() ? "" : ", ", place.slot->name));
    }
  }
}

/// Two modules whose indices fall together: the ESI gives no increment, or one that is too small.
void check_collisions(FindingList& findings, const SlavePlan& slave) {
  std::map<std::uint16_t, int> uses;
  for (const auto& [direction, pdo] : slave.pdos) {
    if (++uses[pdo.index] == 2) {
      findings.warning(
          direction == PdoDirection::kRx ? "pdo.rx" : "pdo.tx",
          fmt::format("Two modules bring PDO 0x{:04X}; the ESI's SlotPdoIncrement does not part them.", pdo.index));
    }
  }
}

}  // namespace

void find_module_problems(FindingList& findings, const SlavePlan& slave) {
  if (slave.settings->modules.empty() && !slave.device().slots) return;
  const auto places = slot_places(slave.device());
  check_plugged(findings, slave, places);
  check_empty(findings, slave, places);
  if (!slave.settings->modules.empty()) check_collisions(findings, slave);
}

}  // namespace syncline::compiler
