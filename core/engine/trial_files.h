// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "config/device_description.h"
#include "findings/finding.h"
#include "support/result.h"

namespace syncline {

struct NetworkConfig;

/// The devices of an ESI file, and those in it that cannot be read.
struct TrialDevices {
  std::vector<DeviceDescription> devices;
  std::vector<Error> rejected;
};

/// The files that a trial of devices reads and writes, in their formats, of which this room knows nothing (eni/trial).
/// Any thread, several at once.
class TrialFiles {
 public:
  virtual ~TrialFiles() = default;
  /// An ESI file. Errors name file and line.
  [[nodiscard]] virtual Result<TrialDevices> read_devices(const std::string& path) const = 0;
  /// An ENI file; never empty.
  [[nodiscard]] virtual std::string eni_of(const NetworkConfig& config) const = 0;
  /// The same to a file. kFileNotWritable.
  [[nodiscard]] virtual Status save_eni(const NetworkConfig& config, const std::string& path) const = 0;
  /// The configuration in the text of an ENI; `name` stands for the file in errors.
  [[nodiscard]] virtual Result<NetworkConfig> read_eni(const std::string& text, const std::string& name) const = 0;
  /// What the checker finds in it, its structure and its meaning.
  [[nodiscard]] virtual Result<std::vector<Finding>> check_eni(const std::string& text,
                                                               const std::string& name) const = 0;
};

}  // namespace syncline
