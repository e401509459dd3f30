// SPDX-License-Identifier: Apache-2.0
#include "compile/dc_init_cmds.h"

#include "compile/init_cmd_builder.h"
#include "compile/slave_plan.h"
#include "config/slave_config.h"
#include "protocol/assign_activate.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline::compiler {

void add_dc_start(InitCmdBuilder& cmds, const SlavePlan& slave) {
  if (!slave.dc_commands()) {
    return;
  }
  const SlaveDcConfig& dc = *slave.dc;
  Bytes cycle_times;
  ByteWriter(cycle_times)
      .u32(static_cast<std::uint32_t>(dc.cycle_time0))
      .u32(static_cast<std::uint32_t>(dc.cycle_time1));
  cmds.fpwr({Transition::kPS}, "set SYNC cycle times", reg::kSync0CycleTime, std::move(cycle_times)).cycle().answered();
  cmds.fpwr({Transition::kPS}, "set SYNC start time", reg::kStartTimeCyclicOperation,
            le_bytes(static_cast<std::uint64_t>(dc.shift_time)))
      .cycle()
      .answered();
  cmds.fpwr({Transition::kPS}, "activate SYNC", reg::kCyclicUnitControl, le_bytes(dc.assign_activate))
      .cycle()
      .answered();
  if (!AssignActivate{dc.assign_activate}.latch_to_pdi()) {
    cmds.fpwr({Transition::kPS}, "set latch control", reg::kLatch0Control, Bytes(2)).cycle();
  }
  cmds.fpwr({Transition::kIP, Transition::kPP}, "stop SYNC", reg::kCyclicUnitControl, Bytes(2)).cycle();
}

void add_dc_stop(InitCmdBuilder& cmds, const SlavePlan& slave) {
  if (slave.dc_commands()) {
    cmds.fpwr({Transition::kSP, Transition::kOP}, "stop SYNC", reg::kCyclicUnitControl, Bytes(2)).cycle();
  }
}

}  // namespace syncline::compiler
