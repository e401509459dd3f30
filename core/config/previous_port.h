// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace syncline {

/// Where a slave hangs: position of the predecessor and its port (0..3 = A..D).
struct PreviousPort {
  std::uint16_t position = 0;
  std::uint8_t port = 1;
  bool operator==(const PreviousPort&) const = default;
};

/// One of the places where a slave may hang, as the ENI names it; the selected one is SlaveConfig::previous.
struct PossiblePort {
  std::uint8_t port = 1;                           // 0..3 = A..D
  std::optional<std::uint16_t> station_address{};  // of the slave in front
  std::optional<std::uint32_t> device_id{};        // deprecated by the schema
  bool operator==(const PossiblePort&) const = default;
};

}  // namespace syncline
