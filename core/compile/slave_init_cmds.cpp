// SPDX-License-Identifier: Apache-2.0
#include "compile/slave_init_cmds.h"

#include "compile/dc_init_cmds.h"
#include "compile/identity_cmds.h"
#include "compile/init_cmd_builder.h"
#include "compile/memory_init_cmds.h"
#include "compile/own_init_cmds.h"
#include "compile/state_init_cmds.h"
#include "protocol/registers.h"
#include "support/byte_order.h"
#include "support/types.h"

namespace syncline::compiler {
namespace {

void add_station_address(InitCmdBuilder& cmds, const SlavePlan& slave) {
  cmds.apwr({Transition::kIP, Transition::kIB}, "set station address", reg::kStationAddress,
            le_bytes(slave.settings->station_address))
      .cycle()
      .answered();
}

void add_watchdogs(InitCmdBuilder& cmds, const DeviceDescription& device) {
  const auto write = [&](const std::optional<std::uint16_t>& value, std::uint16_t address, const char* comment) {
    if (value) {
      cmds.fpwr({Transition::kIP}, comment, address, le_bytes(*value)).answered();
    }
  };
  write(device.reg_0400, reg::kWatchdogDivider, "set watchdog divider");
  write(device.reg_0410, reg::kWatchdogPdi, "set PDI watchdog");
  write(device.reg_0420, reg::kWatchdogProcessData, "set process data watchdog");
}

}  // namespace

std::vector<InitCmd> slave_init_cmds(const SlavePlan& slave, EniDialect dialect) {
  std::vector<InitCmd> out;
  InitCmdBuilder cmds(out, Position{slave.position}.auto_increment_address(), slave.settings->station_address);
  const StateCommands states(slave.device(), dialect);
  const MemoryCommands memory(slave, dialect);

  states.add_back_to_init(cmds, slave.dc_commands());
  states.add_start_in_init(cmds);
  add_identity_check(cmds, slave);
  add_station_address(cmds, slave);
  add_watchdogs(cmds, slave.device());
  memory.add_mailbox(cmds);
  add_dc_start(cmds, slave);
  states.add_request_back_to_preop(cmds);
  memory.add_sync_managers(cmds);
  memory.add_fmmus(cmds);
  states.add_request_back_to_safeop(cmds);
  memory.add_clear_fmmus(cmds);
  add_dc_stop(cmds, slave);
  // Where the slave has all that the transition needs, and is asked for the state only then.
  const auto own = own_slave_cmds(slave.settings->register_commands, slave.settings->station_address);
  out.insert(out.end(), own.begin(), own.end());
  states.add_check_back_to_preop(cmds);
  states.add_preop_and_boot(cmds);
  states.add_safeop_and_op(cmds);
  return out;
}

}  // namespace syncline::compiler
