// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/identity.h"

namespace syncline {

/// A device on the bus, in frame order.
struct FoundDevice {
  Identity identity;
  std::uint16_t station_address = 0;  // 0: it has none (power-on)
  std::uint16_t alias = 0;
  std::optional<std::uint16_t> identified_as{};  // index of the wanted device whose identify commands it answered
  bool operator==(const FoundDevice&) const = default;
};

/// A device as it is configured.
struct WantedDevice {
  Identity identity;  // serial number 0: any
  std::uint16_t station_address = 0;
  std::uint16_t alias = 0;  // 0: none
  bool check_revision = false;
  /// Hot-connect: it may be absent and may stand anywhere; known by its alias or by FoundDevice::identified_as only.
  bool optional = false;
  std::optional<std::uint16_t> follows{};  // member of a hot-connect group: stands directly behind this wanted device
};

/// How the found devices and the wanted ones belong together. Indices are positions on the bus and in the
/// configuration.
struct BusMatch {
  std::vector<std::optional<std::uint16_t>> position;            // of every wanted device
  std::vector<std::uint16_t> missing;                            // wanted, not found
  std::vector<std::uint16_t> absent;                             // the same, but may be
  std::vector<std::uint16_t> extra;                              // found, not wanted
  std::vector<std::pair<std::uint16_t, std::uint16_t>> swapped;  // wanted pairs that stand in each other's place
  std::vector<std::uint16_t> wrong;                              // wanted: another device stands in its place
  [[nodiscard]] bool exact() const { return missing.empty() && extra.empty() && swapped.empty() && wrong.empty(); }
};

[[nodiscard]] bool is_same_device(const WantedDevice& wanted, const FoundDevice& found);

/// The longest sequence of devices that stand in the configured order, devices with an alias wherever they
/// are; the rest is explained as swapped, wrong, missing or extra. Pure.
[[nodiscard]] BusMatch match_bus(std::span<const WantedDevice> wanted, std::span<const FoundDevice> found);

}  // namespace syncline
