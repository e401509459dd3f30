// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "protocol/al_state.h"
#include "support/result.h"

namespace syncline {

class Bus;
class RunState;
class SlaveWork;
class SyncWatch;

/// Positions of slaves in the configuration, ascending.
using SlaveList = std::vector<std::size_t>;

/// What the state machine does with many slaves at a time: their init commands of a transition and
/// their AL status, all slaves side by side.
class SlaveCommands {
 public:
  SlaveCommands(Bus& bus, RunState& run, const SyncWatch& sync);

  /// Which of the transition's commands of a slave run: by their index in its list.
  using Part = std::function<bool(std::size_t slave, std::size_t index)>;

  /// Register commands, or mailbox commands (CoE objects first, then the other protocols). A slave that fails is told
  /// by an event, acknowledged when it reports an error, and taken off the list; it does not keep the others from
  /// finishing. The result is the first slave's error; errors of the bus itself (see ends_everything()) end all. Who
  /// has gone away from a bus with cycles only leaves the list: he is told and brought back as one lost later.
  Status run(SlaveList& slaves, Transition transition, const Part& part = {}) {
    return run(slaves, transition, part, 0);
  }
  Status run_mailbox(SlaveList& slaves, Transition transition);

  /// Switches the SYNC units of slaves off and sets them up again, with more time than the attempts before left.
  Status restart_sync_signals(SlaveList& slaves, unsigned attempt);

  /// What the master's own commands of INIT to PREOP wrote to all slaves (clear FMMUs, SyncManagers, clocks), for
  /// slaves that were not there then.
  Status repeat_broadcasts(std::span<const std::size_t> slaves);

  /// Reads AL status and code of these slaves and tells what is new. Slaves that do not answer are lost.
  Status read_al_status(std::span<const std::size_t> slaves);
  Status read_all();
  /// Acknowledges the error of those that report one; waits until they took it, at most a second.
  Status acknowledge(std::span<const std::size_t> slaves);

  /// The first thing that goes wrong with this slave from here on is kept until it is taken: an error that it reported
  /// is acknowledged, and its AL status says nothing of it any more.
  void keep_failure_of(std::size_t slave) {
    watched_ = slave;
    kept_.reset();
  }
  [[nodiscard]] std::optional<Error> take_failure() {
    watched_.reset();
    return std::exchange(kept_, std::nullopt);
  }

  /// Where slave number `slave` really is, when others in front of it are missing.
  void set_position(std::size_t slave, std::uint16_t position) { positions_[slave] = position; }
  [[nodiscard]] std::uint16_t position(std::size_t slave) const { return positions_[slave]; }

 private:
  struct Failed {
    std::size_t slave;
    std::uint32_t losses;  // of it, before it was asked
    Error error;
  };

  Status run(SlaveList& slaves, Transition transition, const Part& part, unsigned attempt);
  template <class Work, class Messages>
  Status send_all(SlaveList& slaves, Messages messages);
  Status finish(SlaveList& slaves, std::span<SlaveWork* const> works);
  [[nodiscard]] std::vector<std::uint32_t> losses_of(std::span<const std::size_t> slaves) const;
  void leave_out_lost(SlaveList& slaves, std::span<const std::uint32_t> before) const;
  Status report(std::span<const Failed> failed);
  [[nodiscard]] bool was_lost(const Failed& failed) const;
  Status write_acknowledge(std::span<const std::size_t> slaves);

  Bus& bus_;
  RunState& run_;
  const SyncWatch& sync_;
  std::vector<std::uint16_t> positions_;
  std::optional<std::size_t> watched_;
  std::optional<Error> kept_;
};

/// Errors after which going on with the other slaves makes no sense.
[[nodiscard]] bool ends_everything(const Error& error);

}  // namespace syncline
