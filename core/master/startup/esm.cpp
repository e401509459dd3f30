// SPDX-License-Identifier: Apache-2.0
#include "master/startup/esm.h"

#include <algorithm>
#include <array>

#include "config/init_cmd.h"
#include "config/network_config.h"
#include "master/clocks/delay_compensation.h"
#include "master/cyclic/cyclic_task.h"
#include "master/cyclic/mailbox_hold.h"
#include "master/scan/bus_scanner.h"
#include "master/startup/init_cmd_runner.h"
#include "master/startup/sm2_counter_lookup.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

constexpr int kCyclesBeforeOp = 10;  // valid outputs before OP is requested

constexpr unsigned kMostRestarts = 3;  // of SYNC signals that came too late

}  // namespace

Esm::Esm(Bus& bus, RunState& run, CyclicTaskRunner& task, SyncWatch& sync, DelayCompensation& delays)
    : bus_(bus),
      run_(run),
      task_(task),
      commands_(bus, run, sync),
      attendance_(bus, run, commands_),
      clocks_(bus, run, task, sync, delays, attendance_) {}

AlState Esm::state_of(std::size_t slave) const { return al_state_of(run_.snapshot.slaves[slave].al_status); }

Status Esm::reset() {
  const auto expected = run_.config().slaves.size();
  const auto count = count_slaves(bus_);
  if (!count) return tl::unexpected(count.error());
  if (*count == 0) return fail(ErrorCode::kNoResponse, bus_.exchange().link().describe().name);
  if (auto status = attendance_.check(*count); !status) return status;
  // First with the acknowledge, for slaves in error; then without, because an ESC that emulates its
  // device mirrors the acknowledge bit as an error.
  const auto init = static_cast<std::uint16_t>(AlState::kInit);
  for (const auto value : {static_cast<std::uint16_t>(init | kAlErrorFlag), init}) {
    if (auto wkc = bus_.write(Command::kBwr, 0, reg::kAlControl, value); !wkc) return tl::unexpected(wkc.error());
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
  std::uint32_t patience_ms = 0;
  for (const auto& slave : run_.config().slaves) patience_ms = std::max(patience_ms, slave.timeouts.back_to_init);
  const auto end = bus_.clock().now() + patience_ms * kMillisecond;
  std::uint16_t al_status = 0;
  do {
    std::array<std::uint8_t, 2> bytes{};
    if (auto wkc = bus_.exchange(Command::kBrd, 0, reg::kAlStatus, bytes); !wkc) return tl::unexpected(wkc.error());
    al_status = load_le<std::uint16_t>(bytes);
    if (al_state_of(al_status) == AlState::kInit) break;
    if (auto status = bus_.wait_a_little(); !status) return status;
  } while (bus_.clock().now() < end);
  if (al_state_of(al_status) != AlState::kInit) {
    Error error{ErrorCode::kAlTimeout, "at least one slave"};
    error.expected = init;
    error.received = al_status;
    return fail(std::move(error));
  }
  for (std::size_t i = 0; i < expected; ++i) {
    auto& slave = run_.snapshot.slaves[i];
    if (slave.absent_since != 0)
      run_.states.set_present(i, !attendance_.missing(i), bus_.clock().now());  // was told as lost
    slave.present = !attendance_.missing(i);
    slave.al_status = slave.present ? init : 0;
    slave.al_status_code = 0;
    slave.al_status_time = slave.present ? bus_.clock().now() : 0;
  }
  run_.states.note_slave_change();
  run_.states.update_master_state(bus_.clock().now());
  return {};
}

void Esm::abandon() {
  bus_.set_pump(nullptr);
  bus_.exchange().missing().forget_all();
  task_.acyclic().requests().give_up_mailboxes();
  task_.acyclic().mailbox().give_up();
  task_.working_counter().set_joining(false);
  task_.working_counter().set_judging(false);
  task_.frames().expect_without(std::vector<bool>(run_.config().slaves.size()));
  operate(AlState::kInit);
}

/// From now on the cyclic commands of this state are sent.
void Esm::operate(AlState level) {
  level_ = level;
  task_.select(level);
}

Status Esm::change_to(AlState target) {
  run_.snapshot.requested = target;
  const auto all = slaves_where([](AlState) { return true; });
  MailboxHold hold(run_.mailboxes, task_.acyclic().mailbox(), all);
  task_.acyclic().requests().cancel_files();
  if (auto status = hold.settle(bus_); !status) return status;
  // An ended bring-up leaves slaves in states that nobody has looked at.
  if (bus_.cyclic()) {
    if (auto status = commands_.read_all(); !status) return status;
  }
  Status result;
  const auto& slaves = run_.snapshot.slaves;
  if (std::ranges::any_of(slaves, [&](const auto& s) { return is_above(al_state_of(s.al_status), target); })) {
    result = down_to(target);
  }
  if (result && is_above(target, run_.states.lowest_state())) result = up_to(target);
  return result;
}

Status Esm::up_to(AlState target) {
  if (bus_.cyclic()) {
    if (auto status = commands_.acknowledge(slaves_where([](AlState) { return true; })); !status) return status;
  }
  const auto in_init = [](const SlaveStatus& s) { return !s.present || al_state_of(s.al_status) == AlState::kInit; };
  if (std::ranges::all_of(run_.snapshot.slaves, in_init)) {
    if (auto status = init_to_preop(); !status) return status;
  } else if (bus_.cyclic()) {
    // A running bus is not stopped for slaves that fell behind the others.
    const auto behind = slaves_where([](AlState state) { return state == AlState::kInit || state == AlState::kBoot; });
    if (auto status = join(behind, AlState::kPreop); !status) return status;
  }
  if (is_above(target, AlState::kPreop)) {
    if (auto status = preop_to_safeop(); !status) return status;
  }
  if (is_above(target, AlState::kSafeop)) return safeop_to_op();
  return {};
}

// ---- INIT to PREOP ------------------------------------------------------------------------------

Status Esm::init_to_preop() {
  bus_.set_pump(nullptr);  // the clocks are set up anew
  if (auto status = run_master_commands(Transition::kIP, true); !status) return status;
  auto slaves = slaves_where([](AlState) { return true; });
  const auto request = preop_requests();
  // A slave that is not the configured one, or cannot be set up, ends the bring-up before there is a cycle.
  const auto set_up = [&](std::size_t slave, std::size_t index) { return index < request[slave]; };
  if (auto status = commands_.run(slaves, Transition::kIP, set_up); !status) {
    const bool other_device = status.error().code == ErrorCode::kIdentityMismatch;
    if (!other_device) return status;
    return attendance_.explain_refusal(std::move(status));
  }
  const auto first_cycle = clocks_.initialise(slaves_where([](AlState) { return true; }));
  if (!first_cycle) return tl::unexpected(first_cycle.error());
  task_.start(*first_cycle);
  operate(AlState::kPreop);
  bus_.set_pump(&task_);
  if (auto status = clocks_.await_slaves(); !status) return status;
  auto status = commands_.run(slaves, Transition::kIP,
                              [&](std::size_t slave, std::size_t index) { return index >= request[slave]; });
  if (!status && ends_everything(status.error())) return status;
  if (auto coe = commands_.run_mailbox(slaves, Transition::kIP); status) status = std::move(coe);
  if (!status) return status;
  if (status = run_master_commands(Transition::kIP, false); !status) return status;
  if (status = commands_.read_all(); !status) return status;
  return find_sm2_counters(bus_, run_.config(), run_.snapshot, run_.mailboxes, task_.acyclic().sm2());
}

/// Index of the command that requests PREOP, or behind the last one, for every slave.
std::vector<std::size_t> Esm::preop_requests() const {
  std::vector<std::size_t> requests;
  for (const auto& slave : run_.config().slaves) {
    const auto found = std::ranges::find_if(slave.init_cmds, [](const InitCmd& command) {
      return has_transition(command, Transition::kIP) && requests_state(command, AlState::kPreop);
    });
    requests.push_back(static_cast<std::size_t>(found - slave.init_cmds.begin()));
  }
  return requests;
}

/// Slaves that answer and are in a state that `applies` selects.
SlaveList Esm::slaves_where(const std::function<bool(AlState)>& applies) const {
  SlaveList slaves;
  for (std::size_t i = 0; i < run_.snapshot.slaves.size(); ++i) {
    if (run_.snapshot.slaves[i].present && applies(state_of(i))) slaves.push_back(i);
  }
  return slaves;
}

// ---- single slaves ------------------------------------------------------------------------------

Status Esm::join(SlaveList slaves, AlState target, const SlaveList& anew) {
  if (slaves.empty()) return {};
  task_.working_counter().set_joining(true);
  auto status = join_each(std::move(slaves), target, anew);
  task_.working_counter().set_joining(false);
  return status;
}

Status Esm::join_each(SlaveList slaves, AlState target, const SlaveList& to_init) {
  MailboxHold hold(run_.mailboxes, task_.acyclic().mailbox(), slaves);
  if (auto settled = hold.settle(bus_); !settled) return settled;
  if (auto status = commands_.acknowledge(slaves); !status) return status;
  for (const auto slave : to_init) {
    if (!run_.snapshot.slaves[slave].present) continue;
    if (auto status = lead_down(slave, AlState::kInit); !status && ends_everything(status.error())) return status;
  }
  SlaveList anew;
  for (const auto slave : slaves) {
    const auto state = state_of(slave);
    const bool below = state == AlState::kInit || state == AlState::kBoot || state == AlState::kNone;
    if (!run_.snapshot.slaves[slave].present || below) anew.push_back(slave);
  }
  auto status = join_in_preop(std::move(anew));
  if (status && is_above(target, AlState::kPreop)) status = lift(slaves, AlState::kPreop, Transition::kPS);
  if (status && is_above(target, AlState::kSafeop)) {
    // Valid outputs reach the slave before it is asked to take them.
    for (int i = 0; status && i < kCyclesBeforeOp; ++i) status = bus_.wait_a_little();
    if (status) status = lift(slaves, AlState::kSafeop, Transition::kSO);
  }
  if (status) status = commands_.read_all();
  task_.slaves().refresh_al_status();
  return status;
}

Status Esm::lift(const SlaveList& slaves, AlState from, Transition transition) {
  SlaveList ready;
  std::ranges::copy_if(slaves, std::back_inserter(ready), [&](std::size_t slave) {
    return run_.snapshot.slaves[slave].present && state_of(slave) == from;
  });
  if (ready.empty()) return {};
  if (auto status = commands_.run_mailbox(ready, transition); !status && ends_everything(status.error())) return status;
  if (auto status = commands_.run(ready, transition); !status && ends_everything(status.error())) return status;
  if (transition == Transition::kPS) {
    if (auto status = start_sync_signals(ready); !status && ends_everything(status.error())) return status;
  }
  return commands_.read_al_status(slaves);
}

Status Esm::join_in_preop(SlaveList slaves) {
  if (slaves.empty()) return {};
  const auto request = preop_requests();
  if (auto status = commands_.repeat_broadcasts(slaves); !status) return status;
  auto status = commands_.run(slaves, Transition::kIP, [&](auto slave, auto index) { return index < request[slave]; });
  if (!status && ends_everything(status.error())) return status;
  if (status = commands_.read_al_status(slaves); !status) return status;
  if (status = clocks_.join(slaves); !status) return status;
  status = commands_.run(slaves, Transition::kIP, [&](auto slave, auto index) { return index >= request[slave]; });
  if (!status && ends_everything(status.error())) return status;
  status = commands_.run_mailbox(slaves, Transition::kIP);
  if (!status && ends_everything(status.error())) return status;
  return commands_.read_al_status(slaves);
}

// ---- PREOP to SAFEOP to OP ------------------------------------------------------------------------

Status Esm::preop_to_safeop() {
  if (auto status = clocks_.await_master(); !status) return status;
  if (auto status = run_master_commands(Transition::kPS, true); !status) return status;
  if (auto status = step_up(AlState::kPreop, Transition::kPS); !status) return status;
  if (auto status = run_master_commands(Transition::kPS, false); !status) return status;
  if (level_ != AlState::kOp) operate(AlState::kSafeop);
  return {};
}

Status Esm::safeop_to_op() {
  for (int i = 0; i < kCyclesBeforeOp; ++i) {
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
  if (auto status = run_master_commands(Transition::kSO, true); !status) return status;
  if (auto status = step_up(AlState::kSafeop, Transition::kSO); !status) return status;
  if (auto status = run_master_commands(Transition::kSO, false); !status) return status;
  operate(AlState::kOp);
  if (auto status = bus_.wait_a_little(); !status) return status;
  task_.working_counter().set_judging(true);
  task_.expect_present();
  return {};
}

Status Esm::step_up(AlState from, Transition transition) {
  auto slaves = slaves_where([&](AlState state) { return state == from; });
  auto status = commands_.run_mailbox(slaves, transition);
  if (!status && ends_everything(status.error())) return status;
  if (auto registers = commands_.run(slaves, transition); status) status = std::move(registers);
  if (!status && ends_everything(status.error())) return status;
  if (transition == Transition::kPS) {
    if (auto started = start_sync_signals(slaves); status) status = std::move(started);
    if (!status && ends_everything(status.error())) return status;
  }
  if (auto read = commands_.read_all(); !read) return read;
  return status;
}

/// A start time that had passed before the unit was active, because so many slaves or so slow a host took so long, is
/// given again with more time.
Status Esm::start_sync_signals(const SlaveList& slaves) {
  for (unsigned attempt = 1; attempt <= kMostRestarts; ++attempt) {
    auto without = clocks_.without_sync_signals(slaves);
    if (!without) return tl::unexpected(without.error());
    if (without->empty()) return {};
    if (auto status = commands_.restart_sync_signals(*without, attempt); !status && ends_everything(status.error()))
      return status;
  }
  return clocks_.check_sync_signals(slaves);
}

// ---- down -----------------------------------------------------------------------------------------

Status Esm::down_to(AlState target) {
  task_.working_counter().set_judging(false);
  task_.frames().expect_without(std::vector<bool>(run_.config().slaves.size()));
  const auto from = run_.states.lowest_state();
  if (const auto transition = transition_between(from, target)) {
    if (auto status = run_master_commands(*transition, true); !status) return status;
  }
  // Nobody waits for a slave that is gone.
  auto status = Status{};
  for (const auto state : {AlState::kOp, AlState::kSafeop, AlState::kPreop, AlState::kBoot}) {
    const auto down = transition_between(state, target);
    auto slaves = slaves_where([&](AlState s) { return s == state && is_above(s, target); });
    if (!down || slaves.empty()) continue;
    auto step = commands_.run(slaves, *down);
    if (!step && ends_everything(step.error())) return step;
    if (status) status = std::move(step);
  }
  if (auto read = commands_.read_all(); !read) return read;
  if (status) finish_down(target);
  return status;
}

void Esm::finish_down(AlState target) {
  operate(target);
  if (target == AlState::kInit) bus_.set_pump(nullptr);
}

// ---- commands -------------------------------------------------------------------------------------

Status Esm::run_master_commands(Transition transition, bool before_slave) {
  for (const auto& command : run_.config().master.init_cmds) {
    if (!has_transition(command, transition) || command.before_slave != before_slave) continue;
    if (auto status = run_init_cmd(bus_, command, "master"); !status) return status;
  }
  return {};
}

}  // namespace syncline
