// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/device_description.h"
#include "eni/xml/file_warning.h"
#include "support/result.h"

namespace syncline::eni {

class SideFiles;

struct EsiFile {
  std::vector<DeviceDescription> devices;  // file order, hidden revisions included
  std::vector<FileWarning> warnings;
  std::vector<DeviceGroup> groups{};
  std::vector<ModuleDescription> modules{};  // those of the side files too
  std::vector<Error> rejected{};             // one for each device that is left out; detail names it
};

struct EsiReadOptions {
  int language = 1033;  // LcId of the names where a file has several; English else
};

/// Reads an ESI file (ETG.2000) and the files that it refers to. Fails with kXmlMalformed, kNotThatKindOfFile,
/// kXmlMissingElement or kXmlBadValue (file, line, element); a broken device is left out with a warning, the rest is
/// read. An EtherCATModule file gives modules and no devices.
[[nodiscard]] Result<EsiFile> read_esi(const std::string& path, const EsiReadOptions& options = {});
/// The same from text, without other files; `file_name` is for messages and DeviceDescription::source.
[[nodiscard]] Result<EsiFile> parse_esi(std::string_view text, const std::string& file_name,
                                        const EsiReadOptions& options = {});

}  // namespace syncline::eni
