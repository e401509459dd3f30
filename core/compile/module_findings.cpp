// SPDX-License-Identifier: Apache-2.0
#include "compile/module_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compile/finding_list.h"
#include "compile/slave_plan.h"
#include "config/module_description.h"
#include "config/module_slots.h"
#include "config/slave_options.h"
#include "config/slave_settings.h"

namespace syncline::compiler {
namespace {

std::string key_of(std::uint16_t place) { return fmt::format("module.{}", place); }

void check_plugged(FindingList& findings, const SlavePlan& slave, const std::vector<SlotPlace>& places) {
  const SlaveSettings& settings = *slave.settings;
  for (const PluggedModule& plugged : settings.modules) {
    const ModuleDescription* module = settings.device.module(plugged.ident);
    if (plugged.slot >= places.size()) {
      findings.add("module-place-missing", fig::number<"place">(plugged.slot), fig::count<"places">(places.size()));
    } else if (module == nullptr || !accepts(*places[plugged.slot].slot, *module)) {
      findings.add_at(key_of(plugged.slot), "module-does-not-fit", fig::hex32<"module">(plugged.ident),
                      fig::number<"place">(plugged.slot));
    } else if (!module->dc_op_mode.empty() && module->dc_op_mode != settings.dc.op_mode) {
      findings.add("module-demands-mode", fig::text<"module">(module->type), fig::number<"place">(plugged.slot),
                   fig::text<"mode">(module->dc_op_mode));
    }
  }
}

void check_empty(FindingList& findings, const SlavePlan& slave, const std::vector<SlotPlace>& places) {
  for (const SlotPlace& place : places) {
    if (place.demanded && !plugged_module(*slave.settings, place.number)) {
      const auto number = fig::number<"place">(place.number);
      const auto& name = place.slot->name;
      name.empty() ? findings.add_at(key_of(place.number), "module-missing", number)
                   : findings.add_at(key_of(place.number), "module-missing/named", number, fig::text<"name">(name));
    }
  }
}

/// Two modules whose indices fall together: the ESI gives no increment, or one that is too small.
void check_collisions(FindingList& findings, const SlavePlan& slave) {
  std::map<std::uint16_t, int> uses;
  for (const auto& [direction, pdo] : slave.pdos) {
    if (++uses[pdo.index] == 2) {
      findings.add_at(direction == PdoDirection::kRx ? "pdo.rx" : "pdo.tx", "module-pdos-collide",
                      fig::hex16<"pdo">(pdo.index));
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
