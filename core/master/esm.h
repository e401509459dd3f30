// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "master/bus.h"
#include "master/cyclic_task.h"
#include "master/dc_setup.h"
#include "master/init_cmd_runner.h"
#include "master/run_state.h"
#include "master/sync_watch.h"

namespace syncline {

/// EtherCAT state machine of the master: takes all slaves through the states by the init commands of
/// the configuration, and does on the way what no init command says: DC initialisation, waiting for
/// synchronism, DC start times, start and end of the cyclic operation.
class Esm {
 public:
  Esm(Bus& bus, RunState& run, CyclicTaskRunner& task, SyncWatch& sync);

  /// Brings every slave to INIT whatever it is doing and checks that the bus is the configured one in
  /// size. No cyclic operation. kSlaveCount, kNoResponse, kAlTimeout.
  Status reset();
  /// Step by step up, directly down. A slave that fails is told by an event and does not keep the others
  /// from finishing the step; the error is the first one. kAlState, kAlTimeout, kSdoAbort and others of
  /// the init commands; kDcSetup and kDcmOutOfLimit when synchronism is not reached.
  Status change_to(AlState target);

 private:
  Status up_to(AlState target);
  Status init_to_preop();
  Status preop_to_safeop();
  Status safeop_to_op();
  Status down_to(AlState target);
  void finish_down(AlState target);

  Status initialise_clocks();
  Status begin_cyclic();
  Status await_slaves_in_sync();
  Status await_master_in_sync();
  void note_clocks(const DcNetwork& network);

  Status run_master_commands(Transition transition, bool before_slave);
  /// Init commands of one slave; `part` selects among those of the transition.
  Status run_slave_commands(std::size_t slave, Transition transition,
                            const std::function<bool(std::size_t index)>& part = {});
  Status run_coe_commands(std::size_t slave, Transition transition);
  /// Index of the command that requests PREOP, or behind the last one.
  [[nodiscard]] std::size_t preop_request(std::size_t slave) const;
  /// Runs `step` for every slave that `applies` selects; see change_to() about errors.
  Status for_slaves(const std::function<bool(std::size_t)>& applies, const std::function<Status(std::size_t)>& step);
  Status step_up(AlState from, Transition transition);

  void report_failure(std::size_t slave, const Error& error);
  Status acknowledge_errors();
  Status read_al_status(std::size_t slave);
  Status refresh();
  Status quiet_mailboxes();
  [[nodiscard]] AlState state_of(std::size_t slave) const;

  Bus& bus_;
  RunState& run_;
  CyclicTaskRunner& task_;
  SyncWatch& sync_;
  InitCmdRunner init_cmds_;
};

}  // namespace syncline
