// SPDX-License-Identifier: Apache-2.0
#include "config/pdo_sync_manager.h"

#include "config/slave_settings.h"

namespace syncline {

std::optional<std::uint8_t> sync_manager_of(const SlaveSettings& slave, PdoDirection direction, const Pdo& pdo) {
  const auto type = direction == PdoDirection::kRx ? SyncManagerType::kOutputs : SyncManagerType::kInputs;
  const auto& managers = slave.device.sync_managers;
  if (pdo.sync_manager && *pdo.sync_manager < managers.size() && managers[*pdo.sync_manager].type == type) {
    return pdo.sync_manager;
  }
  for (std::size_t n = 0; n < managers.size(); ++n) {
    if (managers[n].type == type && !managers[n].is_virtual) return static_cast<std::uint8_t>(n);
  }
  return std::nullopt;
}

}  // namespace syncline
