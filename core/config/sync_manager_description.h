// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "config/sync_manager_type.h"

namespace syncline {

struct SyncManagerDescription {
  SyncManagerType type = SyncManagerType::kUnused;
  std::uint16_t start_address = 0;
  std::optional<std::uint16_t> min_size, max_size, default_size;
  std::uint8_t control_byte = 0;
  bool enable = false;
  bool is_virtual = false;
  bool op_only = false;
  bool one_byte_mode = false;  // only triggers watchdog and PDI interrupt
  std::optional<bool> watchdog{};
  bool operator==(const SyncManagerDescription&) const = default;
};

}  // namespace syncline
