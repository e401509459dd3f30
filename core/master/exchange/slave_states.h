// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "protocol/al_state.h"
#include "support/types.h"

namespace syncline {

class EventTeller;
struct NetworkConfig;
struct SlaveMailbox;
struct Snapshot;

/// Who answers on the bus and in which AL state: the one place that notes it in the snapshot and tells its changes, the
/// master's state with it. The thread that runs the cycle.
class SlaveStates {
 public:
  /// `mailboxes`: per slave; they count anew and move with its state.
  SlaveStates(const NetworkConfig& config, Snapshot& snapshot, EventTeller& teller, std::span<SlaveMailbox> mailboxes);
  SlaveStates(const SlaveStates&) = delete;
  SlaveStates& operator=(const SlaveStates&) = delete;

  /// Another number after each change of who answers, in which state it is, and of its clock's settings: what is made
  /// of all slaves in each cycle stays what it is until then. Whoever changes them in the snapshot by himself tells it.
  [[nodiscard]] std::uint64_t slave_changes() const { return slave_changes_; }
  void note_slave_change() { ++slave_changes_; }
  /// From here on nobody of ours leads a slave to another state: what goes down was asked by somebody else.
  void watch_for_others(bool watched) { watched_for_others_ = watched; }
  /// Takes over a reading of AL status and code; tells changes and new errors.
  void set_al_status(std::size_t slave, std::uint16_t status, std::uint16_t code, Nanoseconds time);
  /// A slave that does not answer is in no state that anybody knows: kNone.
  void set_present(std::size_t slave, bool present, Nanoseconds time);
  /// How often it went away since the operation began.
  [[nodiscard]] std::uint32_t losses(std::size_t slave) const { return losses_[slave]; }
  /// Every slave answers that has its place; members of hot-connect groups come and go as they like.
  [[nodiscard]] bool complete() const;
  /// Of the slaves that answer; kNone when none does.
  [[nodiscard]] AlState lowest_state() const;
  /// The master's state is the lowest of all slaves, kNone unless they are complete; tells a change.
  void update_master_state(Nanoseconds time);
  [[nodiscard]] bool somebody_absent() const;
  [[nodiscard]] bool somebody_present() const;

 private:
  void place_mailbox(std::size_t slave, AlState state);
  void tell_presence(std::size_t slave, bool present, Nanoseconds time);

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  EventTeller& teller_;
  std::span<SlaveMailbox> mailboxes_;
  std::vector<std::uint32_t> losses_;  // per slave
  std::uint64_t slave_changes_ = 0;
  bool watched_for_others_ = false;
};

}  // namespace syncline
