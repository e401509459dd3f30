// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "compile/compile.h"
#include "config/network_config.h"
#include "eni/format/eni_style.h"
#include "support/result.h"

namespace syncline::eni {

/// How a dialect spells what compile() laid out in it.
[[nodiscard]] EniStyle style_of(EniDialect dialect);

/// ENI text (ETG.2100): deterministic bytes, schema-valid, numbers independent of the locale.
[[nodiscard]] std::string write_eni(const NetworkConfig& config, const EniStyle& style = {});
/// Writes to a temporary file beside `path`, then renames.
[[nodiscard]] Status save_eni(const NetworkConfig& config, const std::string& path, const EniStyle& style = {});
/// Reads an ENI, ours or another tool's. Errors name file, line and element.
[[nodiscard]] Result<NetworkConfig> read_eni(const std::string& path);
[[nodiscard]] Result<NetworkConfig> parse_eni(std::string_view text, const std::string& file_name);

/// An ENI for a project: with a finding for each kind of element or attribute of the file that is not read, its count
/// and first line, so that nothing is lost unsaid.
struct EniImport {
  NetworkConfig config;
  std::vector<Finding> unread;
};
[[nodiscard]] Result<EniImport> import_eni(const std::string& path);
[[nodiscard]] Result<EniImport> import_eni_text(std::string_view text, const std::string& file_name);

}  // namespace syncline::eni
