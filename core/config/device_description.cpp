// SPDX-License-Identifier: Apache-2.0
#include "config/device_description.h"

#include <algorithm>

namespace syncline {

const Pdo* find_pdo(const std::vector<Pdo>& pdos, std::uint16_t index) {
  const auto found = std::ranges::find(pdos, index, &Pdo::index);
  return found == pdos.end() ? nullptr : &*found;
}

std::uint32_t Pdo::bit_length() const {
  std::uint32_t bits = 0;
  for (const PdoEntry& entry : entries) bits += entry.bit_length;
  return bits;
}

std::optional<std::uint32_t> SlotDescription::default_module() const {
  const auto chosen = std::ranges::find_if(modules, &ModuleIdent::is_default);
  if (chosen != modules.end()) return chosen->ident;
  if (min_instances > 0 && !modules.empty()) return modules.front().ident;
  return std::nullopt;
}

const ModuleDescription* DeviceDescription::module(std::uint32_t ident) const {
  const auto found = std::ranges::find(modules, ident, &ModuleDescription::ident);
  return found == modules.end() ? nullptr : &*found;
}

}  // namespace syncline
