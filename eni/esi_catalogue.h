// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/device_description.h"
#include "eni/esi_reader.h"
#include "support/result.h"

namespace syncline::eni {

struct DeviceMatch {
  const DeviceDescription* device = nullptr;
  bool exact_revision = false;
};

/// Devices of the ESI files of some folders, in memory.
class EsiCatalogue {
 public:
  /// Adds every *.xml of a folder (not recursive; files in name order). A file that cannot be read
  /// becomes a warning; only a missing folder is an error.
  Status add_folder(const std::string& path);
  Status add_file(const std::string& path);
  [[nodiscard]] const std::vector<DeviceDescription>& devices() const { return devices_; }
  [[nodiscard]] const std::vector<FileWarning>& warnings() const { return warnings_; }
  /// Exact revision, else the newest revision of the same vendor and product that is not newer, else
  /// the newest one. revision 0 in `identity` means any.
  [[nodiscard]] std::optional<DeviceMatch> find(const Identity& identity) const;

 private:
  std::vector<DeviceDescription> devices_;
  std::vector<FileWarning> warnings_;
};

}  // namespace syncline::eni
