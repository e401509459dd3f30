// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "master/clocks/sync_watch.h"
#include "master/cyclic/cyclic_frame_set.h"
#include "protocol/coe.h"

namespace syncline {

class EventTeller;
class LoopTuning;
struct NetworkConfig;
struct Snapshot;

/// Who leads the distributed clocks while the bus runs: the reference clock, and when it is lost the next slave whose
/// clock is synchronised. When it comes back it follows its substitute until it shows the same time, and then leads
/// again, so that the others do not notice. Allocates nothing.
class ReferenceClock {
 public:
  ReferenceClock(const NetworkConfig& config, Snapshot& snapshot, EventTeller& teller, SyncWatch& sync,
                 CyclicFrameSet& frames, LoopTuning& tuning)
      : config_(config), snapshot_(snapshot), teller_(teller), sync_(sync), frames_(frames), tuning_(tuning) {}

  /// After the DC initialisation: who is to lead whenever it is there, and who does. `by_place`: the configuration's
  /// places on the bus are right, and its commands mean the one that leads.
  void start(std::uint16_t home, std::uint16_t leader, bool by_place);
  /// After slaves were lost or found: a lost leader is replaced. Tells kReferenceClock.
  void look(Nanoseconds time);
  /// Before each cycle: the leading clock is asked by its station address and not by its place. That is another's as
  /// soon as somebody comes or goes, which is known a cycle later: meanwhile all who follow would be told the time of
  /// another, or what the master believes, by another way than frames go now. Only where a device does not know FRMW
  /// the configured commands are sent as long as it is `settled` that nobody has come or gone.
  void address(bool settled);
  /// Station address of the clock that leads, if one does.
  [[nodiscard]] std::optional<std::uint16_t> station() const;
  /// While the one that is to lead comes home in front of its substitute: both clocks' times in one frame.
  void add_to(PendingFrame& frame);
  /// After each cycle: is the one that is to lead near enough?
  void watch(Nanoseconds time);
  /// Nobody leads: which of these slaves ought to, when its clock has been set.
  [[nodiscard]] std::optional<std::uint16_t> candidate(std::span<const std::size_t> slaves) const;
  void lead(std::uint16_t position, Nanoseconds time);
  [[nodiscard]] std::uint16_t home() const { return home_.value_or(0); }
  /// One led, and nobody does any more.
  [[nodiscard]] bool is_lost() const { return home_ && !leader_; }
  /// Position of the slave that leads, if any does.
  [[nodiscard]] std::optional<std::uint16_t> leader() const { return leader_; }

 private:
  /// What was read of the one that comes home.
  struct Approach {
    Nanoseconds begin = 0, last_reading = 0;
    std::int64_t sum = 0;
    int readings = 0;
    int near = 0;  // comparisons in a row
  };
  /// 0x0910 of the one that comes home and of its substitute, latched as one frame passed (ESC data sheet II, 2.37).
  struct Comparison {
    std::array<std::array<std::uint8_t, 4>, 2> bytes{};
    std::array<Datagram, 2> datagrams;
    bool asked = false;
  };
  [[nodiscard]] bool can_lead(std::size_t slave) const;
  [[nodiscard]] std::int64_t near_enough() const;  // ns
  [[nodiscard]] bool is_near();
  [[nodiscard]] bool follows_near();
  [[nodiscard]] bool compares_near();
  [[nodiscard]] std::ptrdiff_t on_way() const;
  void hand_over(std::uint16_t position);
  void tune(std::uint16_t position);
  void lose_lead();

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  EventTeller& teller_;
  SyncWatch& sync_;
  CyclicFrameSet& frames_;
  LoopTuning& tuning_;
  std::optional<std::uint16_t> home_, leader_;
  bool by_place_ = false;      // the configuration's commands mean the home clock by its place or address
  bool places_right_ = false;  // everybody in front of it is there
  std::ptrdiff_t on_way_ = 0;  // slaves that are there in front of the one that leads
  std::optional<Approach> approach_;
  Comparison comparison_;
};

}  // namespace syncline
