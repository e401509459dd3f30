// SPDX-License-Identifier: Apache-2.0
#include "ui/session/eni_machine.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "config/device_description.h"
#include "eni/format/eni_file.h"
#include "recover/recover_project.h"
#include "ui/session/device_catalogue.h"

namespace syncline::ui {
namespace {

std::vector<Identity> identitiesOf(const NetworkConfig& config) {
  std::vector<Identity> identities;
  for (const auto& slave : config.slaves) {
    if (std::ranges::find(identities, slave.identity) == identities.end()) identities.push_back(slave.identity);
  }
  return identities;
}

/// The device for an identity; their serial numbers are of slaves, not of devices.
DeviceLookup lookupIn(const std::vector<DeviceDescription>& devices) {
  return [&devices](const Identity& identity) -> const DeviceDescription* {
    const auto found = std::ranges::find_if(devices, [&](const DeviceDescription& device) {
      const auto& own = device.identity;
      return own.vendor_id == identity.vendor_id && own.product_code == identity.product_code &&
             own.revision_no == identity.revision_no;
    });
    return found == devices.end() ? nullptr : &*found;
  };
}

}  // namespace

Status readEniMachine(const QString& path, DeviceCatalogue& catalogue, QObject* context,
                      std::function<void(RecoveredProject)> then) {
  auto config = eni::read_eni(path.toStdString());
  if (!config) return tl::unexpected(config.error());
  auto identities = identitiesOf(*config);
  catalogue.devices(
      std::move(identities), context,
      [config = std::move(*config), then = std::move(then)](const std::vector<DeviceDescription>& devices) {
        then(recover_project(config, lookupIn(devices)));
      });
  return {};
}

}  // namespace syncline::ui
