// SPDX-License-Identifier: Apache-2.0
#include "app/composition/describe_devices.h"

#include "app/composition/visit_slave.h"
#include "master/device_dictionary_reader.h"

namespace syncline {
namespace {

Status complete(DeviceDescription& device, const VisitRequest& request) {
  return visit_slave(request, [&device](SlaveVisit& visit) -> Status {
    if (auto status = visit.open_mailbox(); !status) return status;
    const auto dictionary = read_device_dictionary(visit.mailbox(), device);
    if (!dictionary) return tl::unexpected(dictionary.error());
    complete_from_dictionary(device, *dictionary);
    return {};
  });
}

}  // namespace

void describe_devices(eni::BuiltProject& built, const std::string& link, const std::atomic<bool>* cancel) {
  auto& slaves = built.project.slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    auto device = slaves[i].device;
    if (device.source != "SII" || !device.mailbox || !device.mailbox->coe) continue;
    const auto position = static_cast<std::uint16_t>(i);
    if (auto status = complete(device, {link, position, cancel}); !status) {
      built.warnings.push_back(status.error());
      continue;
    }
    auto described = default_slave(device, position);
    described.alias = slaves[i].alias;
    described.previous = slaves[i].previous;
    described.dc = slaves[i].dc;
    slaves[i] = std::move(described);
  }
}

}  // namespace syncline
