// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "config/project.h"
#include "findings/finding.h"
#include "support/result.h"

namespace syncline {
struct BusScan;
}  // namespace syncline

namespace syncline::eni {

class EsiCatalogue;

struct BuiltProject {
  Project project;
  std::vector<Finding> warnings;  // of the scan; configured from the SII; other revision taken ...
};

/// Project of a scanned bus: the catalogue's device for each identity, else what the SII says.
[[nodiscard]] BuiltProject project_from_scan(const BusScan& scan, const EsiCatalogue& catalogue);
/// Completes the slaves that have no ESI with what they tell themselves (core/engine/describe_slaves.h); what could not
/// be read is returned.
using SlaveDescriber = std::function<Result<std::vector<Error>>(Project& project)>;
/// The same with slaves completed by `describe`, and what could not be read among the warnings. Its errors; none:
/// slaves stay as their EEPROM describes them.
[[nodiscard]] Result<BuiltProject> project_from_scan(const BusScan& scan, const EsiCatalogue& catalogue,
                                                     const SlaveDescriber& describe);
/// Offline project: devices in bus order, wired as a line. kUnknownDevice names the identity.
[[nodiscard]] Result<Project> project_from_devices(const std::vector<Identity>& devices, const EsiCatalogue& catalogue);

}  // namespace syncline::eni
