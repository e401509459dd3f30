// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/device_description.h"
#include "support/result.h"

namespace syncline {
struct SimConfig;
}  // namespace syncline

namespace syncline::sim {

/// Which device a scenario means.
struct DeviceQuery {
  enum class Kind : std::uint8_t { kEsi, kSii };
  Kind kind = Kind::kEsi;
  std::string path;  // already relative to the scenario's folder
  std::string type;  // ESI Type text; empty = any
  std::optional<std::uint32_t> product_code, revision_no;
};
struct ScenarioDevice {
  DeviceDescription device;
  std::vector<std::uint8_t> sii_image;  // the EEPROM bit for bit; empty: made from the device
};
/// Finds a device in an ESI file (of several that fit, the highest revision) or makes it from an EEPROM image.
/// Given by the composition, because core reads no XML.
using DeviceSource = std::function<Result<ScenarioDevice>(const DeviceQuery& query)>;

/// Reads a TOML scenario. Errors are kTomlMalformed or kScenarioKey with file, line and key.
[[nodiscard]] Result<SimConfig> load_scenario(const std::string& path, const DeviceSource& devices);
/// The same of a text that stands for the file.
[[nodiscard]] Result<SimConfig> parse_scenario(std::string_view text, const std::string& path,
                                               const DeviceSource& devices);

}  // namespace syncline::sim
