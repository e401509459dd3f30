// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "master/startup/attendance.h"
#include "master/startup/clock_steps.h"
#include "master/startup/slave_commands.h"
#include "protocol/al_state.h"

namespace syncline {

class Bus;
class CyclicTaskRunner;
class DelayCompensation;

/// EtherCAT state machine of the master: takes all slaves through the states by the init commands of
/// the configuration, and does on the way what no init command says: DC initialisation, waiting for
/// synchronism, DC start times, start and end of the cyclic operation.
class Esm {
 public:
  Esm(Bus& bus, RunState& run, CyclicTaskRunner& task, SyncWatch& sync, DelayCompensation& delays);

  /// Brings every slave to INIT whatever it is doing and checks that the bus is the configured one in
  /// size. No cyclic operation. kSlaveCount, kNoResponse, kAlTimeout.
  Status reset();
  /// What was begun is left as it is and the cyclic operation ends, without a word to the slaves: reset() comes next.
  void abandon();
  /// Step by step up, directly down. A slave that fails is told by an event and does not keep the others
  /// from finishing the step; the error is the first one. kAlState, kAlTimeout, kSdoAbort and others of
  /// the init commands; kDcSetup and kDcmOutOfLimit when synchronism is not reached.
  Status change_to(AlState target);
  /// Leads these slaves to `target`, each from where it is, while all others go on: a slave that is new on the bus
  /// or in INIT runs its init commands from the beginning and gets its clock set. Slaves that do not come
  /// all the way are told by events and stay where they are. `anew`: those of them that are taken to INIT first,
  /// whatever they are in. Bus errors only.
  Status join(SlaveList slaves, AlState target, const SlaveList& anew = {});
  /// Leads one slave to `target` while the others stay where they are, an error acknowledged first. kAlState with the
  /// code of the step that it refuses, kConfiguration above the state of the bus, bus errors.
  Status lead(std::size_t slave, AlState target);
  /// kAlState when the slave keeps its error.
  Status acknowledge(std::size_t slave);
  [[nodiscard]] SlaveCommands& commands() { return commands_; }
  /// State to which the bus as a whole was led; single slaves may be elsewhere.
  [[nodiscard]] AlState level() const { return level_; }

 private:
  void operate(AlState level);
  Status join_each(SlaveList slaves, AlState target, const SlaveList& anew);
  Status join_in_preop(SlaveList slaves);
  [[nodiscard]] Status check_cyclic(std::size_t slave) const;
  Status lead_alone(std::size_t slave, AlState target);
  Status lead_down(std::size_t slave, AlState target);
  [[nodiscard]] Status judge(std::size_t slave, AlState target) const;
  Status lift(const SlaveList& slaves, AlState from, Transition transition);
  Status up_to(AlState target);
  Status init_to_preop();
  Status preop_to_safeop();
  Status safeop_to_op();
  Status down_to(AlState target);
  void finish_down(AlState target);

  Status run_master_commands(Transition transition, bool before_slave);
  [[nodiscard]] std::vector<std::size_t> preop_requests() const;
  [[nodiscard]] SlaveList slaves_where(const std::function<bool(AlState)>& applies) const;
  Status step_up(AlState from, Transition transition);
  Status start_sync_signals(const SlaveList& slaves);
  [[nodiscard]] AlState state_of(std::size_t slave) const;

  Bus& bus_;
  RunState& run_;
  CyclicTaskRunner& task_;
  SlaveCommands commands_;
  Attendance attendance_;
  ClockSteps clocks_;
  AlState level_ = AlState::kInit;
};

}  // namespace syncline
