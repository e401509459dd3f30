// SPDX-License-Identifier: Apache-2.0
#include "master/startup/slave_commands.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "config/init_cmd.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "master/clocks/dc_start.h"
#include "master/clocks/sync_watch.h"
#include "master/exchange/bus.h"
#include "master/exchange/run_state.h"
#include "master/exchange/slave_name.h"
#include "master/startup/coe_download_work.h"
#include "master/startup/init_cmd_runner.h"
#include "master/startup/startup_message_work.h"
#include "protocol/datagram.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

constexpr Nanoseconds kAcknowledgeTimeout = 1 * kSecond;

template <class Work>
std::vector<SlaveWork*> pointers(std::vector<Work>& works) {
  std::vector<SlaveWork*> all;
  all.reserve(works.size());
  for (auto& work : works) all.push_back(&work);
  return all;
}

std::vector<const StartupCommand*> coe_commands(const SlaveConfig& slave, Transition transition) {
  std::vector<const StartupCommand*> wanted;
  if (!slave.mailbox) return wanted;
  for (const auto& [command, ccs] : slave.mailbox->coe_commands) {
    const bool now = std::ranges::find(command.transitions, transition) != command.transitions.end();
    if (now && command.enabled) wanted.push_back(&command);
  }
  return wanted;
}

}  // namespace

bool ends_everything(const Error& error) {
  return error.code == ErrorCode::kCancelled || error.code == ErrorCode::kLinkIo ||
         error.code == ErrorCode::kLinkDown || error.code == ErrorCode::kNoResponse;
}

SlaveCommands::SlaveCommands(Bus& bus, RunState& run, const SyncWatch& sync)
    : bus_(bus), run_(run), sync_(sync), positions_(run.config().slaves.size()) {
  std::iota(positions_.begin(), positions_.end(), std::uint16_t{0});
}

Status SlaveCommands::run(SlaveList& slaves, Transition transition, const Part& part, unsigned attempt) {
  const auto& config = run_.config();
  const auto begun = bus_.clock().now();
  std::vector<InitCmdWork> works;
  works.reserve(slaves.size());
  for (const auto slave : slaves) {
    const auto& list = config.slaves[slave].init_cmds;
    std::vector<const InitCmd*> commands;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (has_transition(list[i], transition) && (!part || part(slave, i))) commands.push_back(&list[i]);
    }
    InitCmdContext context{slave_name(run_.config(), slave), init_cmd_pause(bus_), std::nullopt, {}};
    if (positions_[slave] != slave)
      context.auto_increment_address = Position{positions_[slave]}.auto_increment_address();
    if (sync_.active() && transition == Transition::kPS) {
      auto pace = dc_start_pace(commands);
      pace.slaves = slaves.size();
      pace.attempt = attempt;
      context.data = [this, slave, pace, begun](const InitCmd& command) -> std::optional<std::vector<std::uint8_t>> {
        if (!writes_dc_start_time(command)) return std::nullopt;
        const auto host = bus_.clock().now();
        const auto now = sync_.reference_time_at(host);
        const auto until_active = time_until_active(pace, host - begun, run_.config().cycle_time());
        auto data = dc_start_data(run_.config(), run_.config().slaves[slave], command, now, sync_.base(),
                                  sync_.start_time(), until_active);
        run_.snapshot.dc.start_time = written_start_time(data, now);
        return data;
      };
    }
    works.emplace_back(std::move(commands), std::move(context));
  }
  return finish(slaves, pointers(works));
}

Status SlaveCommands::restart_sync_signals(SlaveList& slaves, unsigned attempt) {
  std::array<std::uint8_t, 1> off{};
  std::vector<Datagram> writes;
  for (const auto slave : slaves) {
    writes.push_back(
        {Command::kFpwr, device_address(run_.config().slaves[slave].station_address, reg::kActivation), off});
  }
  if (auto status = bus_.transact(writes); !status) return status;
  const auto of_unit = [this](std::size_t slave, std::size_t index) {
    return sets_sync_unit(run_.config().slaves[slave].init_cmds[index]);
  };
  return run(slaves, Transition::kPS, of_unit, attempt);
}

Status SlaveCommands::repeat_broadcasts(std::span<const std::size_t> slaves) {
  for (const auto& command : run_.config().master.init_cmds) {
    if (command.command != Command::kBwr || !command.before_slave || !has_transition(command, Transition::kIP))
      continue;
    // Who answers by its station address keeps it: without it would be missed.
    SlaveList whom(slaves.begin(), slaves.end());
    if (command.ado == reg::kStationAddress)
      std::erase_if(whom, [this](std::size_t slave) { return run_.snapshot.slaves[slave].present; });
    std::vector<std::vector<std::uint8_t>> bytes(whom.size(), command.data);
    std::vector<Datagram> writes;
    for (std::size_t i = 0; i < whom.size(); ++i) {
      bytes[i].resize(command.length());
      const auto adp = Position{positions_[whom[i]]}.auto_increment_address();
      writes.push_back({Command::kApwr, device_address(adp, command.ado), bytes[i]});
    }
    if (auto status = bus_.transact(writes); !status) return status;
  }
  return {};
}

Status SlaveCommands::run_mailbox(SlaveList& slaves, Transition transition) {
  auto status = send_all<CoeDownloadWork>(
      slaves, [&](std::size_t slave) { return coe_commands(run_.config().slaves[slave], transition); });
  if (!status && ends_everything(status.error())) return status;
  auto others = send_all<StartupMessageWork>(slaves, [&](std::size_t slave) {
    const auto& mailbox = run_.config().slaves[slave].mailbox;
    return mailbox ? startup_messages(*mailbox, transition) : std::vector<StartupMessage>{};
  });
  return status ? others : status;
}

/// What each slave is to get, side by side; slaves that fail leave the list.
template <class Work, class Messages>
Status SlaveCommands::send_all(SlaveList& slaves, Messages messages) {
  std::vector<Work> works;
  SlaveList busy, idle;
  works.reserve(slaves.size());
  for (const auto slave : slaves) {
    auto list = messages(slave);
    (list.empty() ? idle : busy).push_back(slave);
    if (list.empty()) continue;
    works.emplace_back(run_.mailboxes[slave], std::move(list));
  }
  const auto losses = losses_of(idle);
  auto status = finish(busy, pointers(works));
  leave_out_lost(idle, losses);
  slaves.clear();
  std::ranges::merge(busy, idle, std::back_inserter(slaves));
  return status;
}

std::vector<std::uint32_t> SlaveCommands::losses_of(std::span<const std::size_t> slaves) const {
  std::vector<std::uint32_t> losses;
  for (const auto slave : slaves) losses.push_back(run_.states.losses(slave));
  return losses;
}

/// Nobody knows what those are in who were lost since and may be back: they are led up as such.
void SlaveCommands::leave_out_lost(SlaveList& slaves, std::span<const std::uint32_t> before) const {
  if (!bus_.cyclic()) return;
  SlaveList stayed;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (run_.states.losses(slaves[i]) == before[i]) stayed.push_back(slaves[i]);
  }
  slaves = std::move(stayed);
}

/// Runs the works (one a slave of the list) and takes off the list those that failed or were lost.
Status SlaveCommands::finish(SlaveList& slaves, std::span<SlaveWork* const> works) {
  const auto losses = losses_of(slaves);
  if (auto status = run_side_by_side(bus_, works); !status) return status;
  std::vector<Failed> failed;
  SlaveList good;
  std::vector<std::uint32_t> losses_of_good;
  for (std::size_t i = 0; i < works.size(); ++i) {
    auto result = works[i]->result();
    if (result) {
      good.push_back(slaves[i]);
      losses_of_good.push_back(losses[i]);
    } else {
      failed.push_back({slaves[i], losses[i], std::move(result.error())});
    }
  }
  leave_out_lost(good, losses_of_good);
  slaves = std::move(good);
  if (failed.empty()) return {};
  for (const auto& each : failed) {
    if (each.slave == watched_ && !kept_) kept_ = each.error;
  }
  if (auto status = report(failed); !status) return status;
  const auto first = std::ranges::find_if(failed, [this](const Failed& f) { return !was_lost(f); });
  return first == failed.end() ? Status{} : fail(std::move(first->error));
}

/// Also one that has come back meanwhile and did not get all. Without cycles nobody looks for who is away: there a
/// slave that does not answer is an error.
bool SlaveCommands::was_lost(const Failed& failed) const {
  return bus_.cyclic() &&
         (!run_.snapshot.slaves[failed.slave].present || run_.states.losses(failed.slave) != failed.losses);
}

Status SlaveCommands::report(std::span<const Failed> failed) {
  // First what each slave was asked and what it says, then the states in which that left them. A slave that was lost
  // has been told as that.
  SlaveList slaves;
  for (const auto& each : failed) {
    if (!was_lost(each)) run_.teller.error(each.error, bus_.clock().now());
    slaves.push_back(each.slave);
  }
  if (auto status = read_al_status(slaves); !status) return status;
  // The acknowledge makes the next request possible.
  return write_acknowledge(slaves);
}

Status SlaveCommands::write_acknowledge(std::span<const std::size_t> slaves) {
  std::vector<std::array<std::uint8_t, 2>> bytes;
  std::vector<Datagram> writes;
  bytes.reserve(slaves.size());
  for (const auto slave : slaves) {
    const auto al_status = run_.snapshot.slaves[slave].al_status;
    if ((al_status & kAlErrorFlag) == 0 || !run_.snapshot.slaves[slave].present) continue;
    store_le(std::span(bytes.emplace_back()), static_cast<std::uint16_t>(al_status & 0x1F));
    const auto station = run_.config().slaves[slave].station_address;
    writes.push_back({Command::kFpwr, device_address(station, reg::kAlControl), bytes.back()});
  }
  return writes.empty() ? Status{} : bus_.transact(writes);
}

Status SlaveCommands::acknowledge(std::span<const std::size_t> slaves) {
  const auto in_error = [&](std::size_t slave) {
    const auto& known = run_.snapshot.slaves[slave];
    return known.present && (known.al_status & kAlErrorFlag) != 0;
  };
  if (std::ranges::none_of(slaves, in_error)) return {};
  if (auto status = write_acknowledge(slaves); !status) return status;
  const auto end = bus_.clock().now() + kAcknowledgeTimeout;
  do {
    if (auto status = bus_.wait_a_little(); !status) return status;
    if (auto status = read_al_status(slaves); !status) return status;
  } while (std::ranges::any_of(slaves, in_error) && bus_.clock().now() < end);
  return {};
}

Status SlaveCommands::read_al_status(std::span<const std::size_t> slaves) {
  std::vector<std::array<std::uint8_t, 6>> bytes(slaves.size());
  std::vector<Datagram> reads;
  reads.reserve(slaves.size());
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    // Before there is a cycle it may not have got its station address yet, and nobody moves: it is asked at its place.
    const bool at_place = !bus_.cyclic() && run_.snapshot.slaves[slaves[i]].present;
    const auto adp = at_place ? Position{positions_[slaves[i]]}.auto_increment_address()
                              : run_.config().slaves[slaves[i]].station_address;
    reads.push_back({at_place ? Command::kAprd : Command::kFprd, device_address(adp, reg::kAlStatus), bytes[i]});
  }
  if (reads.empty()) return {};
  if (auto status = bus_.transact(reads); !status) return status;
  const auto now = bus_.clock().now();
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    run_.states.set_present(slaves[i], reads[i].wkc > 0, now);
    if (reads[i].wkc == 0) continue;
    const std::span<const std::uint8_t> view(bytes[i]);
    run_.states.set_al_status(slaves[i], load_le<std::uint16_t>(view), load_le<std::uint16_t>(view.subspan(4)), now);
  }
  return {};
}

Status SlaveCommands::read_all() {
  SlaveList all(run_.config().slaves.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (auto status = read_al_status(all); !status) return status;
  run_.states.update_master_state(bus_.clock().now());
  return {};
}

}  // namespace syncline
