// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/device_description.h"
#include "support/result.h"

namespace syncline::eni {

/// Something in a file that was tolerated: what and where.
struct FileWarning {
  std::string file;
  int line = 0;
  std::string element;
  std::string text;
  bool operator==(const FileWarning&) const = default;
};

struct EsiFile {
  std::vector<DeviceDescription> devices;   // file order, hidden revisions included
  std::vector<FileWarning> warnings;
};

/// Reads an ESI file (ETG.2000). Fails with kXmlMalformed, kNotThatKindOfFile, kXmlMissingElement or
/// kXmlBadValue (file, line, element); a broken device is left out with a warning, the rest is read.
[[nodiscard]] Result<EsiFile> read_esi(const std::string& path);
/// The same from text; `file_name` is for messages and DeviceDescription::source.
[[nodiscard]] Result<EsiFile> parse_esi(std::string_view text, const std::string& file_name);

}  // namespace syncline::eni
