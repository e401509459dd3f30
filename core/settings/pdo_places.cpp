// SPDX-License-Identifier: Apache-2.0
#include "settings/pdo_places.h"

#include <algorithm>

#include "config/module_slots.h"
#include "config/slave_settings.h"
#include "settings/setting.h"

namespace syncline::settings {
namespace {

template <class Visit>
void each_pdo(const SlaveSettings& settings, Visit visit) {
  std::vector<std::uint16_t> seen;
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    const auto visit_all = [&](const std::vector<Pdo>& pdos) {
      for (const Pdo& pdo : pdos) {
        if (std::ranges::find(seen, pdo.index) != seen.end()) continue;
        seen.push_back(pdo.index);
        visit(pdo);
      }
    };
    if (settings.modules.empty()) {
      visit_all(settings.device.pdos(direction));
    } else {
      visit_all(pdos_of(settings, direction));
    }
  }
}

}  // namespace

std::vector<Place> pdo_places(const SlaveSettings& settings, std::size_t slave) {
  std::vector<Place> places;
  each_pdo(settings, [&](const Pdo& pdo) { places.push_back({slave, pdo.index, 0}); });
  return places;
}

std::vector<Place> entry_places(const SlaveSettings& settings, std::size_t slave) {
  std::vector<Place> places;
  each_pdo(settings, [&](const Pdo& pdo) {
    const auto changed = std::ranges::find(settings.changed_pdos, pdo.index, &Pdo::index);
    const auto& entries = changed == settings.changed_pdos.end() ? pdo.entries : changed->entries;
    for (std::size_t i = 0; i < entries.size() && i <= 0xFFFF; ++i) {
      if (entries[i].index != 0) places.push_back({slave, pdo.index, static_cast<std::uint32_t>(i)});
    }
  });
  return places;
}

}  // namespace syncline::settings
