// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "channels/event.h"
#include "master/startup/slave_commands.h"
#include "protocol/al_state.h"
#include "support/types.h"

namespace syncline {

class Bus;
class CyclicTaskRunner;
class Esm;
struct FoundDevice;
class RunState;

/// Brings slaves back while the others go on: those that come back after a cable was healed or their power
/// returned, those that fell because the adapter was away, and those that fell into an error state, as far as
/// RecoverySettings say so or the user asks.
class Recovery {
 public:
  Recovery(Bus& bus, RunState& run, CyclicTaskRunner& task, Esm& esm);

  /// After a bus cycle; does nothing (and allocates nothing) as long as there is nothing to do. Cycles go on
  /// while it works. Bus errors; kCancelled when a command of the user came in between.
  Status after_cycle();
  /// Takes all slaves that were lost and are there again to PREOP, whatever the settings say: the user's
  /// request, from where the state machine goes on with all slaves.
  Status bring_all_back();

 private:
  struct Track {
    bool returning = false;  // was lost since it was last in the state of the bus
    bool given_up = false;
    std::uint32_t tries = 0;
    std::uint32_t losses = 0;  // known of when it was looked at last
    Nanoseconds next_try = 0;
    std::optional<Nanoseconds> well_since = std::nullopt;
  };

  void look();
  [[nodiscard]] bool due(std::size_t slave, Nanoseconds now) const;
  [[nodiscard]] bool wants_help(std::size_t slave) const;
  [[nodiscard]] bool needs_leader(std::size_t slave) const;
  Status work(bool on_command, AlState target);
  Status locate(SlaveList& found);
  void match_groups(std::vector<FoundDevice>& devices, SlaveList& found);
  [[nodiscard]] std::optional<std::size_t> find_head(std::span<const FoundDevice> devices, std::size_t head) const;
  [[nodiscard]] bool is_new(std::span<const FoundDevice> devices, std::size_t at, std::size_t slave) const;
  [[nodiscard]] std::optional<std::size_t> place_of(std::span<const FoundDevice> devices, std::size_t slave) const;
  void place(std::size_t slave, std::uint16_t position, SlaveList& found);
  [[nodiscard]] bool comes_back(std::size_t slave) const;
  [[nodiscard]] std::optional<std::size_t> known_by(std::uint16_t station) const;
  void match_gap(std::span<const std::uint16_t> wanted, std::span<const std::uint16_t> positions,
                 std::span<const FoundDevice> devices, SlaveList& found);
  void tell(std::size_t slave, events::RecoveryStep::Stage stage);
  [[nodiscard]] std::size_t present_count() const;

  Bus& bus_;
  RunState& run_;
  CyclicTaskRunner& task_;
  Esm& esm_;
  std::vector<Track> tracks_;
  std::uint64_t sweeps_seen_ = 0;
  Nanoseconds next_look_ = 0;
  unsigned outages_seen_ = 0;                                       // of the adapter
  Nanoseconds fall_by_outage_ = 0;                                  // until then a fall is one of its consequences
  std::set<std::pair<std::uint16_t, std::uint64_t>> told_unknown_;  // position, vendor and product
};

}  // namespace syncline
