// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace syncline {
struct DeviceDescription;
struct SimSlaveConfig;
}  // namespace syncline

namespace syncline::sii {
struct Image;
}  // namespace syncline::sii

namespace syncline::sim {

/// Number of a CoE data type by its ESI name (ETG.1000.6, table 64); 0 when it has none.
[[nodiscard]] std::uint8_t data_type_code(std::string_view name);

/// EEPROM content that a vendor's tool would make from an ESI device (ETG.2010).
[[nodiscard]] sii::Image sii_from_device(const DeviceDescription& device, std::uint16_t alias, std::uint32_t serial_no);

/// What a simulated slave's EEPROM holds when it leaves the factory: the scenario's own image, or such a content.
[[nodiscard]] std::vector<std::uint8_t> factory_sii(const SimSlaveConfig& config);

}  // namespace syncline::sim
