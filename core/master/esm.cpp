// SPDX-License-Identifier: Apache-2.0
#include "master/esm.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "master/bus_scanner.h"
#include "master/coe_client.h"
#include "master/dc_setup.h"
#include "master/dc_start.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

constexpr Nanoseconds kResetTimeout = 5 * kSecond;  // ETG default "back to INIT"
constexpr Nanoseconds kSyncTimeout = 30 * kSecond;
constexpr int kCyclesBeforeOp = 10;                 // valid outputs before OP is requested

/// Errors after which going on with the other slaves makes no sense.
bool ends_everything(const Error& error) {
  return error.code == ErrorCode::kCancelled || error.code == ErrorCode::kLinkIo ||
         error.code == ErrorCode::kLinkDown || error.code == ErrorCode::kNoResponse;
}

bool is_above(AlState state, AlState target) { return static_cast<int>(state) > static_cast<int>(target); }

}  // namespace

Esm::Esm(Bus& bus, RunState& run, CyclicTaskRunner& task, SyncWatch& sync)
    : bus_(bus), run_(run), task_(task), sync_(sync), init_cmds_(bus) {}

AlState Esm::state_of(std::size_t slave) const { return al_state_of(run_.snapshot.slaves[slave].al_status); }

Status Esm::reset() {
  const auto expected = run_.config().slaves.size();
  const auto count = count_slaves(bus_);
  if (!count) return tl::unexpected(count.error());
  if (*count == 0) return fail(ErrorCode::kNoResponse, bus_.exchange().link().describe().name);
  if (*count != expected) {
    Error error{ErrorCode::kSlaveCount};
    error.expected = static_cast<std::int64_t>(expected);
    error.received = *count;
    return fail(std::move(error));
  }
  // First with the acknowledge, for slaves in error; then without, because an ESC that emulates its
  // device mirrors the acknowledge bit as an error.
  const auto init = static_cast<std::uint16_t>(AlState::kInit);
  for (const auto value : {static_cast<std::uint16_t>(init | kAlErrorFlag), init}) {
    if (auto wkc = bus_.write(Command::kBwr, 0, reg::kAlControl, value); !wkc) return tl::unexpected(wkc.error());
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
  const auto end = bus_.clock().now() + kResetTimeout;
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
  for (auto& slave : run_.snapshot.slaves) {
    slave.present = true;
    slave.al_status = init;
    slave.al_status_code = 0;
  }
  run_.update_master_state(bus_.clock().now());
  return {};
}

Status Esm::change_to(AlState target) {
  run_.snapshot.requested = target;
  if (auto status = quiet_mailboxes(); !status) return status;
  // An ended bring-up leaves slaves in states that nobody has looked at.
  if (bus_.cyclic()) {
    if (auto status = refresh(); !status) return status;
  }
  Status result;
  const auto& slaves = run_.snapshot.slaves;
  if (std::ranges::any_of(slaves, [&](const auto& s) { return is_above(al_state_of(s.al_status), target); })) {
    result = down_to(target);
  }
  if (result && is_above(target, run_.snapshot.state)) result = up_to(target);
  task_.sm2().set_enabled(bus_.cyclic());
  return result;
}

Status Esm::up_to(AlState target) {
  if (bus_.cyclic()) {
    if (auto status = acknowledge_errors(); !status) return status;
  }
  if (run_.snapshot.state == AlState::kInit) {
    if (auto status = init_to_preop(); !status) return status;
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
  const auto all = [](std::size_t) { return true; };
  auto status = for_slaves(all, [this](std::size_t i) {
    const auto end = preop_request(i);
    return run_slave_commands(i, Transition::kIP, [end](std::size_t index) { return index < end; });
  });
  if (!status) return status;
  if (status = initialise_clocks(); !status) return status;
  if (status = await_slaves_in_sync(); !status) return status;
  status = for_slaves(all, [this](std::size_t i) {
    const auto begin = preop_request(i);
    return run_slave_commands(i, Transition::kIP, [begin](std::size_t index) { return index >= begin; })
        .and_then([&] { return run_coe_commands(i, Transition::kIP); });
  });
  if (!status) return status;
  if (status = run_master_commands(Transition::kIP, false); !status) return status;
  return refresh();
}

std::size_t Esm::preop_request(std::size_t slave) const {
  const auto& commands = run_.config().slaves[slave].init_cmds;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (has_transition(commands[i], Transition::kIP) && requests_state(commands[i], AlState::kPreop)) return i;
  }
  return commands.size();
}

Status Esm::initialise_clocks() {
  std::optional<DcNetwork> network;
  if (configured_reference_clock(run_.config())) {
    auto result = DcSetup(bus_, run_.config()).run();
    if (!result) return tl::unexpected(result.error());
    network = std::move(*result);
    note_clocks(*network);
  }
  const auto first_cycle = bus_.clock().now() + run_.config().cycle_time();
  if (network) sync_.start(*network, first_cycle);
  task_.start(first_cycle);
  task_.select(AlState::kPreop);
  bus_.set_pump(&task_);
  return {};
}

void Esm::note_clocks(const DcNetwork& network) {
  std::vector<std::uint16_t> watched;
  for (std::size_t i = 0; i < network.slaves.size(); ++i) {
    const auto& clock = network.slaves[i];
    auto& slave = run_.snapshot.slaves[i];
    slave.dc_enabled = clock.synchronised;
    slave.is_reference_clock = i == network.reference_clock;
    slave.propagation_delay_ns = clock.delay_ns;
    if (clock.synchronised) watched.push_back(static_cast<std::uint16_t>(i));
  }
  task_.slaves().set_dc_slaves(std::move(watched));
  run_.event(EventKind::kReferenceClock, bus_.clock().now(), network.reference_clock, 1);
}

Status Esm::await_slaves_in_sync() {
  if (!sync_.active()) return {};
  const auto end = bus_.clock().now() + kSyncTimeout;
  while (!sync_.slaves_in_sync()) {
    if (auto status = bus_.wait_a_little(); !status) return status;
    if (bus_.clock().now() < end) continue;
    const auto& dc = run_.snapshot.dc;
    return fail(ErrorCode::kDcSetup, "the slaves",
                fmt::format("they are {} ns apart after {} s, the sync window allows {} ns", dc.deviation_ored_ns,
                            kSyncTimeout / kSecond, dc.limit_ns));
  }
  const auto now = bus_.clock().now();
  if (!sync_.monitored()) run_.event(EventKind::kDcSlaveSync, now, -1, 2, 0);
  std::int64_t count = 0;
  for (const auto& slave : run_.snapshot.slaves) count += slave.dc_enabled ? 1 : 0;
  run_.event(EventKind::kDcInitialised, now, -1, count, run_.snapshot.dc.reference_clock);
  return {};
}

// ---- PREOP to SAFEOP to OP ------------------------------------------------------------------------

Status Esm::await_master_in_sync() {
  if (!sync_.active()) return {};
  const auto end = bus_.clock().now() + kSyncTimeout;
  while (!sync_.master_in_sync()) {
    if (auto status = bus_.wait_a_little(); !status) return status;
    if (bus_.clock().now() < end) continue;
    Error error{ErrorCode::kDcmOutOfLimit, "master"};
    error.expected = run_.config().dc.dcm.in_sync_limit;
    error.received = run_.snapshot.dcm.error_ns;
    return fail(std::move(error));
  }
  return {};
}

Status Esm::preop_to_safeop() {
  if (auto status = await_master_in_sync(); !status) return status;
  if (auto status = run_master_commands(Transition::kPS, true); !status) return status;
  if (auto status = step_up(AlState::kPreop, Transition::kPS); !status) return status;
  if (auto status = run_master_commands(Transition::kPS, false); !status) return status;
  if (run_.snapshot.state != AlState::kOp) task_.select(AlState::kSafeop);
  return {};
}

Status Esm::safeop_to_op() {
  for (int i = 0; i < kCyclesBeforeOp; ++i) {
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
  if (auto status = run_master_commands(Transition::kSO, true); !status) return status;
  if (auto status = step_up(AlState::kSafeop, Transition::kSO); !status) return status;
  if (auto status = run_master_commands(Transition::kSO, false); !status) return status;
  task_.select(AlState::kOp);
  if (auto status = bus_.wait_a_little(); !status) return status;
  task_.health().set_judging(true);
  return {};
}

Status Esm::step_up(AlState from, Transition transition) {
  auto status = for_slaves([&](std::size_t i) { return state_of(i) == from; },
                           [&](std::size_t i) {
                             return run_coe_commands(i, transition).and_then([&] {
                               return run_slave_commands(i, transition);
                             });
                           });
  if (auto refreshed = refresh(); !refreshed) return refreshed;
  return status;
}

// ---- down -----------------------------------------------------------------------------------------

Status Esm::down_to(AlState target) {
  task_.health().set_judging(false);
  const auto from = run_.snapshot.state;
  if (const auto transition = transition_between(from, target)) {
    if (auto status = run_master_commands(*transition, true); !status) return status;
  }
  // Nobody waits for a slave that is gone.
  const auto applies = [&](std::size_t i) { return run_.snapshot.slaves[i].present && is_above(state_of(i), target); };
  auto status = for_slaves(applies,
                           [&](std::size_t i) -> Status {
                             const auto transition = transition_between(state_of(i), target);
                             if (!transition) return {};
                             return run_slave_commands(i, *transition);
                           });
  if (auto refreshed = refresh(); !refreshed) return refreshed;
  if (status) finish_down(target);
  return status;
}

void Esm::finish_down(AlState target) {
  task_.select(target);
  if (target == AlState::kInit) bus_.set_pump(nullptr);
}

// ---- commands -------------------------------------------------------------------------------------

Status Esm::run_master_commands(Transition transition, bool before_slave) {
  for (const auto& command : run_.config().master.init_cmds) {
    if (!has_transition(command, transition) || command.before_slave != before_slave) continue;
    if (auto status = init_cmds_.run(command, "master"); !status) return status;
  }
  return {};
}

Status Esm::run_slave_commands(std::size_t slave, Transition transition,
                               const std::function<bool(std::size_t)>& part) {
  const auto& config = run_.config().slaves[slave];
  const auto subject = run_.slave_name(slave);
  for (std::size_t i = 0; i < config.init_cmds.size(); ++i) {
    const auto& command = config.init_cmds[i];
    if (!has_transition(command, transition) || (part && !part(i))) continue;
    Status status;
    if (sync_.active() && transition == Transition::kPS && writes_dc_start_time(command)) {
      const auto now = sync_.reference_time_at(bus_.clock().now());
      status = init_cmds_.run(command, dc_start_data(run_.config(), config, command, now, sync_.base()), subject);
    } else {
      status = init_cmds_.run(command, subject);
    }
    if (!status) return status;
  }
  return {};
}

Status Esm::run_coe_commands(std::size_t slave, Transition transition) {
  const auto& config = run_.config().slaves[slave];
  if (!config.mailbox) return {};
  CoeClient client(bus_, config, run_.mailbox_counters[slave], [&](const coe::Emergency& emergency) {
    run_.event(EventKind::kEmergency, bus_.clock().now(), static_cast<int>(slave), emergency.error_code,
               emergency.error_register);
  });
  for (const auto& [command, ccs] : config.mailbox->coe_commands) {
    const bool wanted = std::ranges::find(command.transitions, transition) != command.transitions.end();
    if (!wanted || !command.enabled) continue;
    client.set_timeout_ms(command.timeout_ms);
    const auto status = client.download({command.index, command.sub_index}, command.data, command.complete_access);
    if (!status) return status;
  }
  return {};
}

Status Esm::for_slaves(const std::function<bool(std::size_t)>& applies,
                       const std::function<Status(std::size_t)>& step) {
  Status result;
  for (std::size_t i = 0; i < run_.config().slaves.size(); ++i) {
    if (!applies(i)) continue;
    auto status = step(i);
    if (status) {
      if (status = read_al_status(i); !status) return status;
      continue;
    }
    if (ends_everything(status.error())) return status;
    report_failure(i, status.error());
    if (result) result = std::move(status);
  }
  return result;
}

// ---- AL status ------------------------------------------------------------------------------------

void Esm::report_failure(std::size_t slave, const Error& error) {
  if (error.code == ErrorCode::kAlState) {
    // The event is told by the reading; the acknowledge makes the next request possible.
    if (!read_al_status(slave)) return;
    const auto al_status = run_.snapshot.slaves[slave].al_status;
    if ((al_status & kAlErrorFlag) == 0) return;
    (void)bus_.write(Command::kFpwr, run_.config().slaves[slave].station_address, reg::kAlControl, al_status);
  } else {
    run_.error(error, bus_.clock().now());
  }
}

Status Esm::acknowledge_errors() {
  for (std::size_t i = 0; i < run_.config().slaves.size(); ++i) {
    const auto al_status = run_.snapshot.slaves[i].al_status;
    if ((al_status & kAlErrorFlag) == 0) continue;
    const auto station = run_.config().slaves[i].station_address;
    if (auto wkc = bus_.write(Command::kFpwr, station, reg::kAlControl, al_status); !wkc) {
      return tl::unexpected(wkc.error());
    }
    if (auto status = bus_.wait_a_little(); !status) return status;
    if (auto status = read_al_status(i); !status) return status;
  }
  return {};
}

Status Esm::read_al_status(std::size_t slave) {
  std::array<std::uint8_t, 6> bytes{};
  const auto wkc = bus_.exchange(Command::kFprd, run_.config().slaves[slave].station_address, reg::kAlStatus, bytes);
  if (!wkc) return tl::unexpected(wkc.error());
  const auto now = bus_.clock().now();
  run_.set_present(slave, *wkc > 0, now);
  if (*wkc > 0) {
    const std::span<const std::uint8_t> view(bytes);
    run_.set_al_status(slave, load_le<std::uint16_t>(view), load_le<std::uint16_t>(view.subspan(4)), now);
  }
  return {};
}

Status Esm::refresh() {
  for (std::size_t i = 0; i < run_.config().slaves.size(); ++i) {
    if (auto status = read_al_status(i); !status) return status;
  }
  run_.update_master_state(bus_.clock().now());
  return {};
}

Status Esm::quiet_mailboxes() {
  task_.sm2().set_enabled(false);
  while (bus_.cyclic() && !task_.sm2().idle()) {
    if (auto status = bus_.wait_a_little(); !status) return status;
  }
  return {};
}

}  // namespace syncline
