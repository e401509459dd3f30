// SPDX-License-Identifier: Apache-2.0
#include "config/module_slots.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "config/device_description.h"
#include "config/slave_options.h"
#include "config/slave_settings.h"
#include "reasons/because.h"

namespace syncline {
namespace {

constexpr std::size_t kMaxPlaces = 1024;

using Indices = std::vector<std::uint16_t>;

std::uint16_t moved(std::uint16_t index, unsigned by) { return static_cast<std::uint16_t>(index + by); }

/// The slot's own increment, else that of all slots.
std::uint16_t increment(const std::optional<std::uint16_t>& own, const std::optional<std::uint16_t>& common) {
  return own ? *own : common.value_or(0);
}

Pdo pdo_at(Pdo pdo, const SlotPlace& place) {
  const auto move_pdo = [&](std::uint16_t index, bool by_slot, bool by_group) {
    return moved(index, (by_slot ? place.pdo_offset : 0U) + (by_group ? place.group_pdo_offset : 0U));
  };
  for (auto& excluded : pdo.exclude) {
    const bool moves = std::ranges::find(pdo.exclude_by_slot, excluded) != pdo.exclude_by_slot.end();
    excluded = move_pdo(excluded, moves, moves && pdo.depend_on_slot_group);
  }
  pdo.exclude_by_slot.clear();
  pdo.index = move_pdo(pdo.index, pdo.depend_on_slot, pdo.depend_on_slot_group);
  for (PdoEntry& entry : pdo.entries) {
    entry.index = moved(entry.index, (entry.depend_on_slot ? place.index_offset : 0U) +
                                         (entry.depend_on_slot_group ? place.group_index_offset : 0U));
    entry.depend_on_slot = entry.depend_on_slot_group = false;
  }
  pdo.depend_on_slot = pdo.depend_on_slot_group = false;
  return pdo;
}

/// A plugged module at its place, described.
struct Plugged {
  SlotPlace place;
  ModuleDescription module;
};

std::vector<Plugged> plugged_modules(const SlaveSettings& slave) {
  std::vector<Plugged> plugged;
  const auto places = slot_places(slave.device);
  for (const PluggedModule& choice : slave.modules) {
    const ModuleDescription* module = slave.device.module(choice.ident);
    if (module != nullptr && choice.slot < places.size()) {
      plugged.push_back({places[choice.slot], module_at(*module, places[choice.slot])});
    }
  }
  return plugged;
}

/// Where a PDO stands in the process data of a modular device: group of its module, place, order of the ESI.
class PdoOrder {
 public:
  PdoOrder(const SlaveSettings& slave, PdoDirection direction) {
    int number = 0;
    for (const Pdo& pdo : slave.device.pdos(direction)) {
      entries_.push_back({pdo.index, slave.device.module_pdo_group.value_or(0), -1, number++, pdo.bit_length()});
    }
    for (const auto& [place, module] : plugged_modules(slave)) {
      number = 0;
      for (const Pdo& pdo : direction == PdoDirection::kRx ? module.rx_pdos : module.tx_pdos) {
        entries_.push_back({pdo.index, module.pdo_group.value_or(0), place.number, number++, pdo.bit_length()});
      }
    }
  }

  void sort(Indices& assigned) const {
    std::ranges::stable_sort(assigned, [this](std::uint16_t a, std::uint16_t b) { return rank(a) < rank(b); });
  }
  [[nodiscard]] int group(std::uint16_t index) const { return find(index).group; }
  [[nodiscard]] std::uint32_t bits(std::uint16_t index) const { return find(index).bits; }

 private:
  struct Entry {
    std::uint16_t index = 0;
    int group = 0, place = 0, number = 0;
    std::uint32_t bits = 0;
  };
  [[nodiscard]] Entry find(std::uint16_t index) const {
    const auto found = std::ranges::find(entries_, index, &Entry::index);
    return found == entries_.end() ? Entry{} : *found;
  }
  [[nodiscard]] std::tuple<int, int, int> rank(std::uint16_t index) const {
    const Entry entry = find(index);
    return {entry.group, entry.place, entry.number};
  }
  std::vector<Entry> entries_;
};

std::optional<std::uint16_t> gap_pdo(const ModulePdoGroup& group, PdoDirection direction) {
  return direction == PdoDirection::kRx ? group.rx_pdo : group.tx_pdo;
}

/// Groups in their order, and the PDO that fills up to the alignment in front of a group that would start odd.
void order_assignment(SlaveSettings& slave, PdoDirection direction) {
  Indices& assigned = slave.assigned_pdos(direction);
  const auto& groups = slave.device.slots->pdo_groups;
  for (const ModulePdoGroup& group : groups) {
    if (const auto gap = gap_pdo(group, direction)) std::erase(assigned, *gap);
  }
  const PdoOrder order(slave, direction);
  order.sort(assigned);
  Indices filled;
  std::uint32_t bits = 0;
  int previous = 0;
  for (const std::uint16_t index : assigned) {
    const int group = order.group(index);
    if (group != previous && group > 0 && static_cast<std::size_t>(group) <= groups.size()) {
      const ModulePdoGroup& described = groups[static_cast<std::size_t>(group) - 1];
      const auto gap = gap_pdo(described, direction);
      if (gap && described.alignment > 0 && bits % (described.alignment * 8U) != 0) {
        filled.push_back(*gap);
        bits += order.bits(*gap);
      }
    }
    previous = group;
    filled.push_back(index);
    bits += order.bits(index);
  }
  assigned = std::move(filled);
}

void pull(SlaveSettings& slave, const SlotPlace& place, const ModuleDescription& module) {
  const ModuleDescription at_place = module_at(module, place);
  for (const Pdo& pdo : at_place.rx_pdos) std::erase(slave.assigned_rx_pdos, pdo.index);
  for (const Pdo& pdo : at_place.tx_pdos) std::erase(slave.assigned_tx_pdos, pdo.index);
  const auto belongs = [&](std::uint16_t index) {
    const auto is_it = [index](const Pdo& pdo) { return pdo.index == index; };
    return std::ranges::any_of(at_place.rx_pdos, is_it) || std::ranges::any_of(at_place.tx_pdos, is_it);
  };
  std::erase_if(slave.changed_pdos, [&](const Pdo& pdo) { return belongs(pdo.index); });
  std::erase_if(slave.oversampling, [&](const PdoOversampling& o) { return belongs(o.pdo); });
  std::erase_if(slave.variable_names, [&](const VariableName& v) { return belongs(v.pdo); });
  if (!at_place.coe) return;
  for (const StartupCommand& command : at_place.coe->init_commands) {
    const auto known = std::ranges::find(slave.startup, command);
    if (known != slave.startup.end()) slave.startup.erase(known);
  }
}

void plug(SlaveSettings& slave, const SlotPlace& place, const ModuleDescription& module) {
  const ModuleDescription at_place = module_at(module, place);
  const auto assign = [](const std::vector<Pdo>& pdos, Indices& assigned) {
    for (const Pdo& pdo : pdos) {
      const bool excluded = std::ranges::any_of(
          pdo.exclude, [&](std::uint16_t other) { return std::ranges::find(assigned, other) != assigned.end(); });
      const bool there = std::ranges::find(assigned, pdo.index) != assigned.end();
      if ((pdo.sync_manager || pdo.mandatory) && !there && (!excluded || pdo.mandatory)) assigned.push_back(pdo.index);
    }
  };
  assign(at_place.rx_pdos, slave.assigned_rx_pdos);
  assign(at_place.tx_pdos, slave.assigned_tx_pdos);
  if (at_place.coe) {
    const auto& commands = at_place.coe->init_commands;
    slave.startup.insert(slave.startup.end(), commands.begin(), commands.end());
  }
}

std::string allowed_modules(const SlaveSettings& slave, const SlotDescription& slot) {
  constexpr int kNamed = 8;
  std::string list;
  int count = 0;
  for (const ModuleDescription& module : slave.device.modules) {
    if (!accepts(slot, module)) continue;
    if (++count <= kNamed) list += fmt::format("{}0x{:08x} {}", list.empty() ? "" : ", ", module.ident, module.type);
  }
  return count == 0 ? "none" : count <= kNamed ? list : list + fmt::format(" and {} more", count - kNamed);
}

}  // namespace

std::vector<SlotPlace> slot_places(const DeviceDescription& device) {
  std::vector<SlotPlace> places;
  if (!device.slots) return places;
  const SlotsDescription& slots = *device.slots;
  const std::size_t limit = std::min<std::size_t>(slots.max_slot_count.value_or(kMaxPlaces), kMaxPlaces);
  SlotPlace next;
  for (const SlotDescription& slot : slots.slots) {
    for (std::uint32_t i = 0; i < slot.max_instances && places.size() < limit; ++i) {
      next.slot = &slot;
      next.demanded = i < slot.min_instances;
      const unsigned group = slot.slot_group.value_or(0);
      const auto& own = slot.increments;
      const auto& common = slots.increments;
      next.group_pdo_offset = moved(0, group * increment(own.slot_group_pdo, common.slot_group_pdo));
      next.group_index_offset = moved(0, group * increment(own.slot_group_index, common.slot_group_index));
      places.push_back(next);
      ++next.number;
      next.pdo_offset = moved(next.pdo_offset, increment(own.slot_pdo, common.slot_pdo));
      next.index_offset = moved(next.index_offset, increment(own.slot_index, common.slot_index));
    }
  }
  return places;
}

bool accepts(const SlotDescription& slot, const ModuleDescription& module) {
  const bool by_ident =
      std::ranges::any_of(slot.modules, [&](const ModuleIdent& m) { return m.ident == module.ident; });
  return by_ident || (!module.module_class.empty() && std::ranges::any_of(slot.classes, [&](const ModuleClass& c) {
           return c.name == module.module_class;
         }));
}

ModuleDescription module_at(const ModuleDescription& module, const SlotPlace& place) {
  ModuleDescription at = module;
  for (auto* pdos : {&at.rx_pdos, &at.tx_pdos}) {
    for (Pdo& pdo : *pdos) pdo = pdo_at(std::move(pdo), place);
  }
  if (at.coe) {
    for (StartupCommand& command : at.coe->init_commands) {
      command.index = moved(command.index, (command.depend_on_slot ? place.index_offset : 0U) +
                                               (command.depend_on_slot_group ? place.group_index_offset : 0U));
      command.depend_on_slot = command.depend_on_slot_group = false;
    }
  }
  return at;
}

std::optional<std::uint32_t> plugged_module(const SlaveSettings& slave, std::uint16_t place) {
  const auto found = std::ranges::find(slave.modules, place, &PluggedModule::slot);
  return found == slave.modules.end() ? std::nullopt : std::optional(found->ident);
}

Status plug_module(SlaveSettings& slave, std::uint16_t number, std::optional<std::uint32_t> ident) {
  const auto places = slot_places(slave.device);
  if (number >= places.size()) {
    return fail(ErrorCode::kBadValue, {},
                because("the device has {count} places for modules, counted from 0", places.size()));
  }
  const SlotPlace& place = places[number];
  const ModuleDescription* module = ident ? slave.device.module(*ident) : nullptr;
  if (ident && (module == nullptr || !accepts(*place.slot, *module))) {
    return fail(ErrorCode::kBadValue, {},
                because("module 0x{module} does not fit into place {place}; these do: {modules}",
                        fmt::format("{:08x}", *ident), number, allowed_modules(slave, *place.slot)));
  }
  const auto before = plugged_module(slave, number);
  if (before == ident) return {};
  if (const auto* old = before ? slave.device.module(*before) : nullptr) pull(slave, place, *old);
  std::erase_if(slave.modules, [number](const PluggedModule& m) { return m.slot == number; });
  if (module != nullptr) {
    const auto at = std::ranges::upper_bound(slave.modules, number, {}, &PluggedModule::slot);
    slave.modules.insert(at, {number, *ident});
    plug(slave, place, *module);
  }
  order_assignment(slave, PdoDirection::kRx);
  order_assignment(slave, PdoDirection::kTx);
  return {};
}

void plug_default_modules(SlaveSettings& slave) {
  for (const SlotPlace& place : slot_places(slave.device)) {
    const auto ident = place.slot->default_module();
    const bool marked =
        ident && std::ranges::any_of(place.slot->modules, [&](const ModuleIdent& m) { return m.is_default; });
    // A default that does not fit is the ESI's fault; the place stays empty and the findings say so.
    if (ident && (marked || place.demanded)) static_cast<void>(plug_module(slave, place.number, ident));
  }
}

std::vector<Pdo> pdos_of(const SlaveSettings& slave, PdoDirection direction) {
  std::vector<Pdo> pdos = slave.device.pdos(direction);
  for (auto& [place, module] : plugged_modules(slave)) {
    for (Pdo& pdo : direction == PdoDirection::kRx ? module.rx_pdos : module.tx_pdos) {
      std::erase_if(pdos, [&](const Pdo& own) { return own.overwritten_by_module && own.index == pdo.index; });
      pdos.push_back(std::move(pdo));
    }
  }
  return pdos;
}

std::optional<Pdo> pdo_of(const SlaveSettings& slave, std::uint32_t index) {
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    const auto find = [index](const std::vector<Pdo>& pdos) -> std::optional<Pdo> {
      const auto found = std::ranges::find_if(pdos, [index](const Pdo& pdo) { return pdo.index == index; });
      return found == pdos.end() ? std::nullopt : std::optional(*found);
    };
    auto pdo = slave.modules.empty() ? find(slave.device.pdos(direction)) : find(pdos_of(slave, direction));
    if (pdo) return pdo;
  }
  return std::nullopt;
}

DeviceDescription device_with_modules(const SlaveSettings& slave) {
  DeviceDescription device = slave.device;
  device.rx_pdos = pdos_of(slave, PdoDirection::kRx);
  device.tx_pdos = pdos_of(slave, PdoDirection::kTx);
  if (!device.mailbox || !device.mailbox->coe) return device;
  for (const auto& [place, module] : plugged_modules(slave)) {
    if (!module.coe) continue;
    auto& commands = device.mailbox->coe->init_commands;
    commands.insert(commands.end(), module.coe->init_commands.begin(), module.coe->init_commands.end());
  }
  return device;
}

}  // namespace syncline
