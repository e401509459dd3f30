// SPDX-License-Identifier: Apache-2.0
#include "compile/mailbox_plan.h"

#include <algorithm>

#include "compile/slave_plan.h"
#include "config/device_description.h"
#include "config/mailbox_config.h"
#include "support/byte_order.h"

namespace syncline::compiler {
namespace {

MailboxChannel channel(const SyncManagerDescription& manager) {
  const auto length = manager.default_size ? manager.default_size
                      : manager.max_size   ? manager.max_size
                                           : manager.min_size;
  return {manager.start_address, length.value_or(0)};
}

}  // namespace

std::optional<MailboxPlan> plan_mailbox(const DeviceDescription& device) {
  const auto& managers = device.sync_managers;
  const auto out = std::ranges::find(managers, SyncManagerType::kMailboxOut, &SyncManagerDescription::type);
  const auto in = std::ranges::find(managers, SyncManagerType::kMailboxIn, &SyncManagerDescription::type);
  if (out == managers.end() || in == managers.end()) {
    return std::nullopt;
  }
  MailboxPlan plan;
  plan.out_number = static_cast<std::uint8_t>(out - managers.begin());
  plan.in_number = static_cast<std::uint8_t>(in - managers.begin());
  plan.out_control = out->control_byte;
  plan.in_control = in->control_byte;
  plan.out = channel(*out);
  plan.in = channel(*in);
  plan.uses_status_bit = std::ranges::find(device.fmmus, FmmuUse::kMailboxState) != device.fmmus.end();
  if (device.eeprom.boot_strap.size() >= 8) {
    ByteReader reader(device.eeprom.boot_strap);
    const MailboxChannel boot_out{reader.u16(), reader.u16()};
    const MailboxChannel boot_in{reader.u16(), reader.u16()};
    if (boot_out.length != 0 && boot_in.length != 0) {
      plan.bootstrap_out = boot_out;
      plan.bootstrap_in = boot_in;
    }
  }
  return plan;
}

MailboxConfig mailbox_config(const SlavePlan& slave, std::uint32_t poll_time_ms) {
  MailboxConfig config;
  const MailboxPlan& plan = *slave.mailbox;
  config.send = plan.out;
  config.receive = plan.in;
  if (plan.uses_status_bit) {
    config.status_bit_address = plan.status_bit;
  } else {
    config.poll_time_ms = poll_time_ms;
  }
  config.bootstrap_send = plan.bootstrap_out;
  config.bootstrap_receive = plan.bootstrap_in;
  if (const auto& described = slave.device().mailbox) {
    config.data_link_layer = described->data_link_layer;
    config.aoe = described->aoe;
    config.eoe = described->eoe;
    config.coe = described->coe.has_value();
    config.foe = described->foe;
    config.soe = described->soe;
    config.voe = described->voe;
    config.timeouts = {described->request_timeout_ms, described->response_timeout_ms};
    if (config.coe) {
      config.profiles = slave.device().profiles;
    }
  }
  return config;
}

}  // namespace syncline::compiler
