// SPDX-License-Identifier: Apache-2.0
#include "engine/describe_slaves.h"

#include <algorithm>

#include "config/device_description.h"
#include "config/device_dictionary.h"
#include "config/project.h"
#include "engine/open_bus.h"
#include "master/exchange/bus.h"
#include "master/mailbox/device_dictionary_reader.h"
#include "master/startup/slave_visit.h"

namespace syncline {
namespace {

bool is_undescribed(const DeviceDescription& device) {
  return device.source == "SII" && device.mailbox && device.mailbox->coe;
}

Status read_into(DeviceDescription& device, SlaveVisit& visit) {
  if (auto status = visit.open_mailbox(); !status) return status;
  const auto dictionary = read_device_dictionary(visit.mailbox(), device);
  if (!dictionary) return tl::unexpected(dictionary.error());
  complete_from_dictionary(device, *dictionary);
  return {};
}

Status complete(DeviceDescription& device, Bus& bus, std::uint16_t position) {
  SlaveVisit visit(bus, position);
  if (auto status = visit.look(); !status) return status;
  const auto read = read_into(device, visit);
  const auto left = visit.leave();
  return read ? left : read;
}

}  // namespace

std::vector<Error> describe_slaves(Project& project, Bus& bus) {
  std::vector<Error> unread;
  auto& slaves = project.slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    auto device = slaves[i].device;
    if (!is_undescribed(device)) continue;
    const auto position = static_cast<std::uint16_t>(i);
    if (auto status = complete(device, bus, position); !status) {
      unread.push_back(status.error());
      if (status.error().code == ErrorCode::kCancelled) return unread;
      continue;
    }
    auto described = default_slave(device, position);
    described.alias = slaves[i].alias;
    described.previous = slaves[i].previous;
    described.dc = slaves[i].dc;
    slaves[i] = std::move(described);
  }
  return unread;
}

Result<std::vector<Error>> describe_slaves(Project& project, const std::function<Result<OpenedLink>()>& open,
                                           const std::atomic<bool>* cancel) {
  if (!has_undescribed_slaves(project)) return std::vector<Error>();
  const auto bus = OpenBus::open(open(), cancel);
  if (!bus) return tl::unexpected(bus.error());
  return describe_slaves(project, (*bus)->bus());
}

bool has_undescribed_slaves(const Project& project) {
  return std::ranges::any_of(project.slaves, [](const SlaveSettings& slave) { return is_undescribed(slave.device); });
}

}  // namespace syncline
