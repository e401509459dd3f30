// SPDX-License-Identifier: Apache-2.0
#include "app/composition/describe_slaves.h"

#include <algorithm>

#include "app/composition/open_bus.h"
#include "master/bus.h"
#include "master/device_dictionary_reader.h"
#include "master/slave_visit.h"

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

void describe_slaves(eni::BuiltProject& built, Bus& bus) {
  auto& slaves = built.project.slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    auto device = slaves[i].device;
    if (!is_undescribed(device)) continue;
    const auto position = static_cast<std::uint16_t>(i);
    if (auto status = complete(device, bus, position); !status) {
      built.warnings.push_back(status.error());
      if (status.error().code == ErrorCode::kCancelled) return;
      continue;
    }
    auto described = default_slave(device, position);
    described.alias = slaves[i].alias;
    described.previous = slaves[i].previous;
    described.dc = slaves[i].dc;
    slaves[i] = std::move(described);
  }
}

Status describe_slaves(eni::BuiltProject& built, std::string_view link, const std::atomic<bool>* cancel) {
  if (!has_undescribed_slaves(built)) return {};
  const auto bus = OpenBus::open(link, cancel);
  if (!bus) return tl::unexpected(bus.error());
  describe_slaves(built, (*bus)->bus());
  return {};
}

bool has_undescribed_slaves(const eni::BuiltProject& built) {
  return std::ranges::any_of(built.project.slaves, [](const SlaveSettings& slave) { return is_undescribed(slave.device); });
}

}  // namespace syncline
