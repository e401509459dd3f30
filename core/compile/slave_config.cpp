// SPDX-License-Identifier: Apache-2.0
#include "compile/slave_config.h"

#include <algorithm>

#include "compile/coe_init_cmds.h"
#include "compile/mailbox_init_cmds.h"
#include "compile/mailbox_plan.h"
#include "compile/master_init_cmds.h"
#include "compile/own_init_cmds.h"
#include "compile/product_revision.h"
#include "compile/slave_init_cmds.h"
#include "compile/slave_plan.h"
#include "config/master_settings.h"
#include "config/slave_settings.h"
#include "protocol/registers.h"

namespace syncline::compiler {
namespace {

constexpr std::uint32_t kEcEngineerPollTimeMs = 10;
constexpr std::uint32_t kTwinCatPollTimeMs = 50;

MailboxConfig mailbox_with_commands(const SlavePlan& plan, EniDialect dialect) {
  const std::uint32_t usual = dialect == EniDialect::kEcEngineer ? kEcEngineerPollTimeMs : kTwinCatPollTimeMs;
  MailboxConfig mailbox = mailbox_config(plan, plan.settings->mailbox.poll_time_ms.value_or(usual));
  mailbox.coe_commands = coe_init_cmds(plan, dialect);
  add_mailbox_init_cmds(mailbox, plan);
  return mailbox;
}

/// The ENI has no letter for ports with Fast Hot-Connect (ESI "H"), which are 100BASE-TX otherwise.
std::string ports_of(std::string physics) {
  std::ranges::replace(physics, 'H', 'Y');
  return physics;
}

}  // namespace

SlaveConfig slave_config(const SlavePlan& plan, EniDialect dialect) {
  const SlaveSettings& settings = *plan.settings;
  SlaveConfig config;
  config.name = settings.name;
  config.station_address = settings.station_address;
  config.auto_increment_address = Position{plan.position}.auto_increment_address();
  config.alias = settings.alias;
  config.physics = ports_of(settings.device.physics);
  config.identity = settings.device.identity;
  if (dialect == EniDialect::kTwinCat) config.product_revision = product_revision(settings.device);
  if (!settings.check.serial) config.identity.serial_no = 0;
  if (settings.check.device_id) {
    config.identification =
        Identification{settings.device.identification_ado.value_or(reg::kAlStatusCode), *settings.check.device_id};
  }
  for (const auto& channel : plan.channels) {
    config.sync_managers.push_back({channel.number, channel.description, channel.pdos, {}});
  }
  config.pdos = plan.pdos;
  if (plan.mailbox) config.mailbox = mailbox_with_commands(plan, dialect);
  config.init_cmds = slave_init_cmds(plan, dialect);
  config.previous = settings.previous;
  config.dc = plan.dc;
  config.timeouts = settings.device.timeouts;
  return config;
}

MasterConfig master_config(const MasterSettings& settings, const std::vector<SlavePlan>& plans,
                           const DcMasterSettings& dc, std::uint16_t mailbox_states) {
  MasterConfig config;
  config.name = settings.name;
  config.destination_mac = settings.destination_mac;
  config.source_mac = settings.source_mac;
  const auto eoe_slaves = std::ranges::count_if(plans, [](const SlavePlan& plan) {
    return plan.mailbox && plan.device().mailbox && plan.device().mailbox->eoe && plan.settings->eoe.enabled;
  });
  config.eoe = eoe_slaves > 0;
  // A port for each slave and one for the host; frames as TwinCAT and EC-Engineer write them.
  constexpr std::uint32_t kFrames = 100, kFramesOfSlave = 20;
  if (config.eoe) {
    const auto count = static_cast<std::uint32_t>(eoe_slaves);
    config.eoe_settings.max_ports = count + 1;
    config.eoe_settings.max_frames = kFrames + kFramesOfSlave * count;
  }
  if (mailbox_states > 0) config.mailbox_state_count = mailbox_states;
  config.init_cmds = master_init_cmds();
  if (dc.dcm.standard_loop_values) {
    std::erase_if(config.init_cmds, [](const InitCmd& command) {
      return command.ado == reg::kSpeedCounterStart || command.ado == reg::kFilterDepthDifference;
    });
  }
  const auto own = own_master_cmds(settings.register_commands);
  config.init_cmds.insert(config.init_cmds.end(), own.begin(), own.end());
  return config;
}

}  // namespace syncline::compiler
