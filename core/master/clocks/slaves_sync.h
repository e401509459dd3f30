// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dc/sync_verdict.h"
#include "support/types.h"

namespace syncline {

struct CycleSample;
struct DcNetwork;
class EventTeller;
struct NetworkConfig;
struct OredDeviation;
class SlaveStates;
struct Snapshot;

/// Slaves against their reference clock: hands the readings of each cycle to the verdict, keeps the result in the
/// snapshot and the sample, tells the edges and names who is to blame. Allocates nothing after start().
class SlavesSync {
 public:
  SlavesSync(const NetworkConfig& config, Snapshot& snapshot, const SlaveStates& states, EventTeller& teller)
      : config_(config), snapshot_(snapshot), states_(states), teller_(teller) {}

  /// `steered`: the reference clock's own 0x092C is its error against the host, because the master writes its 0x0910.
  void start(const DcNetwork& network, Nanoseconds first_cycle, bool steered);
  /// One cycle, after its readings. `led`: there is a reference clock; `distributed`: its time reached the slaves in
  /// this cycle, without which 0x092C says nothing new; `read`: the slaves whose own 0x092C came with it.
  void observe(Nanoseconds time, bool led, bool distributed, std::span<const std::uint16_t> read,
               const std::optional<OredDeviation>& ored, CycleSample& sample);
  /// Others answer than in the cycle before: who it is may take long to find out where cycles are.
  void note_other_way() { other_way_ = verdict_time_; }
  /// Somebody left the sync window, or may have: the slaves' own readings must say, soon.
  [[nodiscard]] bool wants_readings() const { return out_since_.has_value() || round_since_.has_value(); }
  /// Who follows is known until a slave changes, and no cycle looks at all of them again.
  [[nodiscard]] bool settled() const { return known_.has_value() && awaited_.empty(); }

 private:
  /// Whether the same slaves follow as in the cycle before, and only those `read` may have other readings.
  bool take_readings(Nanoseconds time, bool distributed, std::span<const std::uint16_t> read);
  void look_who_follows(Nanoseconds time);
  /// It has a clock and stands behind the reference clock.
  [[nodiscard]] bool may_follow(std::size_t slave) const;
  /// Whether a slave behind the reference clock follows, with what became of it while it was away.
  [[nodiscard]] bool follows_again(std::size_t slave, Nanoseconds time);
  void note_catching_up(std::size_t slave, Nanoseconds time);
  void tell_return(std::size_t slave, Nanoseconds time);
  /// Whether it counts again.
  [[nodiscard]] bool is_back(std::size_t slave, Nanoseconds time) const;
  [[nodiscard]] dc::OredReading meaning(const OredDeviation& ored) const;
  void report(Nanoseconds time, CycleSample& sample);
  void look_closer(Nanoseconds time);
  void tell(dc::SyncVerdict::Edge edge, Nanoseconds time);
  /// As soon as it is known who it was; `at_once`: whatever is known.
  void tell_culprit(Nanoseconds time, bool at_once = false);
  [[nodiscard]] std::optional<std::size_t> who_moved(Nanoseconds time) const;
  [[nodiscard]] bool has_moved(std::size_t slave, Nanoseconds time, Nanoseconds before) const;
  void note_off(Nanoseconds time);
  [[nodiscard]] std::optional<std::size_t> first_of_a_way() const;
  [[nodiscard]] bool somebody_may_come() const;
  [[nodiscard]] bool all_read_since(Nanoseconds time) const;

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  const SlaveStates& states_;
  EventTeller& teller_;
  dc::SyncVerdict verdict_;
  std::vector<dc::ClockReading> readings_;
  // Bytes, because all of them are asked in each cycle:
  std::vector<std::uint8_t> lost_;      // 1: were away and have not caught up
  std::vector<std::uint8_t> returned_;  // 1: have, and it is not told yet that they are in sync
  /// Of one that was away and answers again: since when, and since when its readings are within the limit.
  struct Return {
    std::optional<Nanoseconds> since, near_since;
  };
  std::vector<Return> returns_;
  std::size_t followers_ = 0;
  bool alone_ = true;  // no clock answers that is neither a follower nor the reference clock
  struct Known {
    std::uint64_t changes = 0;
    int leader = -1;
    bool operator==(const Known&) const = default;
  };
  std::optional<Known> known_;  // who follows stays as it is as long as this does, and until somebody awaited comes
  std::vector<std::size_t> awaited_;  // answer and have yet to catch up
  bool steered_ = false;
  Nanoseconds verdict_time_ = 0;          // of the last cycle
  std::optional<Nanoseconds> other_way_;  // when others answered than before
  std::uint32_t ored_ns_ = 0;
  std::optional<Nanoseconds> out_since_;  // out of sync, and not told yet
  std::uint32_t out_by_ = 0;
  int out_culprit_ = -1;
  std::size_t out_count_ = 0;
  bool out_alike_ = false;
  /// Who has been seen over the limit meanwhile, and to which side.
  struct Off {
    std::optional<std::size_t> first;
    bool later = false, sooner = false, far = false;
  } off_;
  std::optional<std::size_t> way_of_;  // the slave behind which the frames' way has changed
  bool was_undecided_ = false;
  std::optional<Nanoseconds> round_since_;  // everybody is to be read
  Nanoseconds next_round_ = 0;
};

}  // namespace syncline
