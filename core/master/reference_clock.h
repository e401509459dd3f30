// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "master/cyclic_frame_set.h"
#include "master/run_state.h"
#include "master/sync_watch.h"

namespace syncline {

/// Who leads the distributed clocks while the bus runs: the configured reference clock, and when it is lost
/// the next slave whose clock is synchronised. The configured one leads again when it has been set up anew;
/// until then its time is handed to nobody. Allocates nothing.
class ReferenceClock {
 public:
  ReferenceClock(RunState& run, SyncWatch& sync, CyclicFrameSet& frames) : run_(run), sync_(sync), frames_(frames) {}

  /// After the DC initialisation: who is to lead and who does. `by_place`: the configuration's places on the bus are
  /// right, and so are its commands.
  void start(std::uint16_t configured, std::uint16_t leader, bool by_place);
  /// After slaves were lost or found: a lost leader is replaced. Tells kReferenceClock.
  void look(Nanoseconds time);
  /// The configured clock shows the system time again.
  void take_back(Nanoseconds time);
  [[nodiscard]] std::optional<std::uint16_t> configured() const { return configured_; }
  /// Position of the slave that leads, if any does.
  [[nodiscard]] std::optional<std::uint16_t> leader() const { return leader_; }

 private:
  void lead(std::uint16_t position, Nanoseconds time);

  RunState& run_;
  SyncWatch& sync_;
  CyclicFrameSet& frames_;
  std::optional<std::uint16_t> configured_, leader_;
};

}  // namespace syncline
