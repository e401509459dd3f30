// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "channels/event.h"
#include "channels/snapshot.h"
#include "master/exchange/slave_mailbox.h"
#include "protocol/al_state.h"

namespace syncline {

struct MasterChannels;
struct NetworkConfig;

/// What everybody who takes part in running a bus reads and writes: the configuration, the latest
/// status of everything, and the way to the outside. Lives in the thread that runs the cycle.
class RunState {
 public:
  /// `adapter`: name of the link, for what is told of it.
  RunState(const NetworkConfig& config, MasterChannels& channels, SharedText adapter = {});
  RunState(const RunState&) = delete;
  RunState& operator=(const RunState&) = delete;

  [[nodiscard]] const NetworkConfig& config() const { return config_; }
  [[nodiscard]] MasterChannels& channels() { return channels_; }

  Snapshot snapshot;
  /// Another number after each change of who answers, in which state it is, and of its clock's settings: what is made
  /// of all slaves in each cycle stays what it is until then. Whoever changes them in the snapshot by himself tells it.
  [[nodiscard]] std::uint64_t slave_changes() const { return slave_changes_; }
  void note_slave_change() { ++slave_changes_; }
  /// From here on nobody of ours leads a slave to another state: what goes down was asked by somebody else.
  void watch_for_others(bool watched) { watched_for_others_ = watched; }
  std::vector<std::uint16_t> deviations_read;  // the slaves whose deviation came with the latest cycle
  std::vector<SlaveMailbox> mailboxes;         // per slave; each with its bit in the process image

  /// `slave` -1: the master, the bus. Notifications that the configuration switches off are left out.
  void event(Nanoseconds time, int slave, EventDetails what);
  void error(const Error& error, Nanoseconds time);
  void emergency(std::size_t slave, const coe::Emergency& emergency, Nanoseconds time);
  /// Tells of a slave that comes and goes as it likes; false when it is none.
  bool hot_connect(std::size_t slave, events::HotConnect::What what, Nanoseconds time);
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
  [[nodiscard]] std::string slave_name(std::size_t slave) const;
  /// The master's adapter is there, or away; tells a change.
  void note_link(bool up, Nanoseconds time);
  /// How often it has gone away.
  [[nodiscard]] unsigned link_outages() const { return link_outages_; }
  [[nodiscard]] std::optional<Nanoseconds> link_away_since() const { return link_away_since_; }
  [[nodiscard]] bool somebody_absent() const;
  [[nodiscard]] bool somebody_present() const;

 private:
  [[nodiscard]] bool told(const EventDetails& what) const;
  void place_mailbox(std::size_t slave, AlState state);

  const NetworkConfig& config_;
  MasterChannels& channels_;
  SharedText adapter_;
  std::vector<SharedText> groups_;  // per slave, of the heads of hot-connect groups
  std::optional<Nanoseconds> link_away_since_;
  unsigned link_outages_ = 0;
  std::vector<std::uint32_t> losses_;  // per slave
  std::uint64_t slave_changes_ = 0;
  bool watched_for_others_ = false;
};

}  // namespace syncline
