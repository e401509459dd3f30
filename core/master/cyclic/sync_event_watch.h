// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dc/sync_event_account.h"

namespace syncline {

class CyclicFrameSet;
struct CycleSample;
struct NetworkConfig;
class SlaveStates;
struct Snapshot;
class SyncWatch;

/// Follows the missed SM2 events of every slave with SYNC0 from cycle to cycle: where its outputs arrived in its SYNC0
/// period, and what that does to its internal error counter; see dc/sync_event_account.h. Allocates nothing; the cyclic
/// thread.
class SyncEventWatch {
 public:
  SyncEventWatch(const NetworkConfig& config, Snapshot& snapshot, const SlaveStates& states, const SyncWatch& sync);

  /// The frames of a cycle.
  struct Sent {
    const CyclicFrameSet& frames;  // of which tasks they are
    bool back = false;             // all of them came back,
    Nanoseconds held = 0;          // by so much later than frames usually do, ns
  };
  /// One cycle. Not before SYNC0 has its grid.
  /// Tells in the sample the count of one slave that has changed since it was told.
  void observe(CycleSample& sample, const Sent& sent);
  /// So many cycles whose outputs were thought to be lost came back after all. Before observe() of the cycle in which
  /// they came.
  void came_late(std::uint32_t cycles);
  /// A reading of the slave's counter of missed events.
  void read(std::size_t slave, std::uint32_t counter);
  void set_limit(std::size_t slave, std::uint32_t limit);
  /// Its misses are counted here, once it is in OP.
  [[nodiscard]] bool follows(std::size_t slave) const { return slave < place_.size() && place_[slave] != kNone; }
  /// What the slave takes from its outputs to SYNC0 (0x1C32:06), ns.
  void set_calc_and_copy(std::size_t slave, Nanoseconds time);
  /// What the outputs of each slave with SYNC0 nominally have beyond the time that it takes for them, the least of all,
  /// ns; the end of time where nobody has SYNC0. Of a slave that does not say what it takes half a cycle is thought
  /// to be enough; of one without a mailbox, a terminal, a quarter.
  [[nodiscard]] Nanoseconds room();
  /// All that are in OP are looked at together, in closed form, until one of them changes.
  [[nodiscard]] bool together() const { return together_.has_value(); }

 private:
  static constexpr auto kNone = static_cast<std::size_t>(-1);
  struct Slave {
    std::size_t position = 0;
    Nanoseconds period = 0, shift = 0;
    Nanoseconds wire = 0;  // until the frame with its outputs has passed
    std::size_t task = 0;  // that carries them
    std::optional<dc::SyncEventAccount> account;
    std::optional<dc::SyncEventAccount> before;  // while it settles: what counts when it stays in OP
    std::uint32_t limit = 0;
    std::optional<std::uint32_t> told;
    Nanoseconds need = 0;  // see SyncEventAccount::Cycle
    std::optional<Nanoseconds> in_op_since, at_limit_since;
    bool away = false;     // it was in OP when it answered last: whether it still is, nobody knows
    bool fallen = false;   // with an AL status code that says so: it left OP by its own count of misses
    bool gave_up = false;  // the same, and that is not explained yet
    // While all of its cycles are regular they are counted only, and the account gets them when it is asked:
    std::optional<Nanoseconds> next{};  // begin of the period in which the next outputs are to come
    std::int64_t regular = 0;
    std::uint32_t left_out = 0;  // cycles since its outputs went out last
  };
  /// Those of one cycle.
  struct Outputs {
    Nanoseconds send_time = 0, passed = 0;  // the master, by the host's clock; the reference clock, by its own
    bool back = false;
    std::uint32_t skipped = 0;  // cycles before
    Nanoseconds held = 0;       // see SyncEventAccount::Cycle
    const CyclicFrameSet& frames;
    [[nodiscard]] bool regular() const { return back && skipped == 0; }
  };
  /// The cycles of all slaves in OP are regular, and will be as long as outputs pass the reference clock in time. Who
  /// is not in OP counts nothing.
  struct Together {
    // Of the time in which the next ones must do so; half of all time, where nobody is in OP, bears additions.
    Nanoseconds begin = INT64_MIN / 2, end = INT64_MAX / 2;
    Nanoseconds period = 0;     // 0: nobody is in OP
    std::uint64_t changes = 0;  // SlaveStates::slave_changes()
    std::int64_t cycles = 0;    // since then; not yet counted in the slaves
  };
  [[nodiscard]] bool pass_together(Nanoseconds passed);
  void settle_all();
  void observe_each(const Outputs& outputs);
  [[nodiscard]] Slave* find(std::size_t position);
  void follow_state(Slave& slave, Nanoseconds time);
  /// False as long as it is away.
  [[nodiscard]] bool follow_presence(Slave& slave) const;
  static void confirm(Slave& slave, Nanoseconds time);
  /// The outputs came at `time`: when they should, after all others did.
  [[nodiscard]] bool observe_regular(Slave& slave, Nanoseconds time) const;
  /// From here on it is the account that counts.
  static void settle(Slave& slave);
  void note_fall(Slave& slave);
  void explain_fall(Slave& slave);
  [[nodiscard]] Nanoseconds nominal_margin(const Slave& slave) const;
  [[nodiscard]] Nanoseconds room_of(const Slave& slave) const;
  void publish(const Slave& slave);
  void tell(CycleSample& sample);
  /// It found into OP: what it counted on the way there is forgotten.
  void end_settling(Slave& slave, Nanoseconds time) const;
  [[nodiscard]] dc::Sync0Grid grid_of(const Slave& slave) const;

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  const SlaveStates& states_;
  const SyncWatch& sync_;
  std::vector<Slave> slaves_;
  std::optional<Together> together_;
  bool news_ = false;  // a count has changed that may not have been told
  /// What room() was found of.
  struct Room {
    Nanoseconds room = 0;
    std::uint64_t changes = 0;  // SlaveStates::slave_changes()
    std::int32_t set_value = 0;
  };
  std::optional<Room> room_;
  std::vector<std::size_t> place_;  // in slaves_, by position; npos: it has no SYNC0
};

}  // namespace syncline
