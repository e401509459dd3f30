// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "config/network_config.h"
#include "support/result.h"

namespace syncline::eni {

/// ENI text (ETG.2100): deterministic bytes, schema-valid, numbers independent of the locale.
[[nodiscard]] std::string write_eni(const NetworkConfig& config);
/// Writes to a temporary file beside `path`, then renames.
[[nodiscard]] Status save_eni(const NetworkConfig& config, const std::string& path);
/// Reads an ENI, ours or another tool's. Errors name file, line and element.
[[nodiscard]] Result<NetworkConfig> read_eni(const std::string& path);
[[nodiscard]] Result<NetworkConfig> parse_eni(std::string_view text, const std::string& file_name);

}  // namespace syncline::eni
