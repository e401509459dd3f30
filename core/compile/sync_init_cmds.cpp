// SPDX-License-Identifier: Apache-2.0
#include "compile/sync_init_cmds.h"

#include <fmt/format.h>

#include <algorithm>

#include "compile/slave_plan.h"
#include "config/device_description.h"
#include "config/slave_settings.h"
#include "families/device_family.h"
#include "families/families.h"
#include "protocol/assign_activate.h"
#include "settings/sync_settings.h"
#include "support/byte_order.h"

namespace syncline::compiler {
namespace {

using Bytes = std::vector<std::uint8_t>;

StartupCommand download(coe::ObjectAddress object, Bytes data, std::string comment) {
  StartupCommand command;
  command.index = object.index;
  command.sub_index = object.sub_index;
  command.data = std::move(data);
  command.fixed = true;
  command.comment = std::move(comment);
  return command;
}

/// ETG.1020 has 16 bits, some devices have 32: the dictionary knows.
Bytes error_limit_bytes(const DeviceDescription& device, std::uint16_t limit) {
  Bytes data = le_bytes(limit);
  const auto object = std::ranges::find(device.dictionary, families::kSyncErrorLimit.index, &ObjectDescription::index);
  if (object == device.dictionary.end()) return data;
  const auto entry = std::ranges::find(object->entries, families::kSyncErrorLimit.sub_index, &ObjectEntry::sub_index);
  if (entry != object->entries.end() && entry->bit_length == 32) data.resize(4);
  return data;
}

bool starts_up_with(const SlavePlan& slave, coe::ObjectAddress object) {
  return std::ranges::any_of(slave.settings->startup, [&](const StartupCommand& command) {
    return command.enabled && command.index == object.index && command.sub_index == object.sub_index;
  });
}

void add_sync(std::vector<StartupCommand>& out, const SlavePlan& slave) {
  const SyncSettings& sync = slave.settings->sync;
  if (sync.type) {
    const bool has_outputs = std::ranges::any_of(slave.channels, [](const ProcessDataChannel& channel) {
      return channel.is_output() && channel.bit_length > 0;
    });
    const auto value = [&](PdoDirection direction) {
      return le_bytes(sync_type_value(*sync.type, direction, has_outputs));
    };
    out.push_back(
        download({families::kOutputSync, 1}, value(PdoDirection::kRx), "synchronisation type of the outputs"));
    out.push_back(download({families::kInputSync, 1}, value(PdoDirection::kTx), "synchronisation type of the inputs"));
  }
  if (sync.input_shift) {
    out.push_back(download({families::kInputSync, 3}, le_bytes(static_cast<std::uint32_t>(*sync.input_shift)),
                           "input shift time"));
  }
  if (sync.error_limit) {
    out.push_back(download(families::kSyncErrorLimit, error_limit_bytes(slave.device(), *sync.error_limit),
                           "sync error counter limit"));
  }
}

void add_can(std::vector<StartupCommand>& out, const SlavePlan& slave, const families::CanGateway& gateway) {
  const CanSettings& can = slave.settings->can;
  if (can.cycle) {
    const bool sync0 = slave.dc && AssignActivate{slave.dc->assign_activate}.sync0();
    if (!sync0 && *can.cycle > 0 && !starts_up_with(slave, gateway.told_cycle)) {
      out.push_back(download(gateway.told_cycle, le_bytes(static_cast<std::uint32_t>(slave.cycle_time)), "bus cycle"));
    }
    out.push_back(download(gateway.can_cycle, le_bytes(static_cast<std::uint32_t>(*can.cycle)), "CAN cycle"));
  }
  if (can.tx_delay_percent) {
    out.push_back(download(gateway.tx_pdo_delay, {*can.tx_delay_percent}, "delay of the synchronous RxPDOs"));
  }
}

void add_pins(std::vector<StartupCommand>& out, const SlavePlan& slave, const families::PinObject& pins) {
  for (const OutputPin& pin : slave.settings->output_pins) {
    Bytes data(std::max<std::size_t>(pins.bytes, 2));
    store_le(std::span(data).first(2), pin.function);
    out.push_back(download({pins.index, pin.pin}, std::move(data), fmt::format("output pin {}", pin.pin)));
  }
}

}  // namespace

std::vector<StartupCommand> sync_commands(const SlavePlan& slave) {
  std::vector<StartupCommand> out;
  if (!check_sync_settings(*slave.settings)) return out;  // told as a finding
  add_sync(out, slave);
  const auto* family = families::find(slave.device());
  if (family != nullptr && family->gateway) add_can(out, slave, *family->gateway);
  if (family != nullptr && family->pins) add_pins(out, slave, *family->pins);
  return out;
}

}  // namespace syncline::compiler
