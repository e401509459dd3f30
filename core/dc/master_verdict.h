// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "channels/values/sync_obstacle.h"
#include "support/types.h"

/// Whether the master is in sync with the reference clock: decided here and nowhere else, from values
/// (docs/distributed-clocks.md, "How the verdict is made").
namespace syncline::dc {

/// The controller judges its schedule. This judges what reaches the slaves: frames that were sent too late or not at
/// all are no sync, however good the schedule is, and neither is a schedule that nobody has held against the reference
/// clock lately. States and transitions only; one thread.
class MasterVerdict {
 public:
  struct Settings {
    Nanoseconds settle = 0;
    Nanoseconds stale = 0;  // without the reference clock's time for longer: nothing is known
    Nanoseconds late_allowed =
        0;  // frame error at which the frame meets SYNC0 at the last slave: set value less the way there
  };
  /// One cycle.
  struct Input {
    Nanoseconds time = 0;  // host clock
    bool led = true;
    bool read = false;                            // the reference clock's time came
    bool schedule_in_sync = false;                // says the controller
    SyncObstacle external = SyncObstacle::kNone;  // DCX: what keeps the reference clock from the external one
    bool clock_stepped = false;                   // the reference clock, as this cycle made sure
    std::uint32_t error_code = 0;                 // of the controller
    std::int64_t skipped_cycles = 0;              // just before this one
    Nanoseconds frame_error = 0;                  // schedule error plus how late the frame was sent
  };

  MasterVerdict() = default;
  MasterVerdict(const Settings& settings, Nanoseconds start) : settings_(settings), read_(start) {}
  void observe(const Input& input);
  /// Another clock leads, or one that comes back: the settle time begins again.
  void distrust(Nanoseconds time);

  [[nodiscard]] bool in_sync() const { return obstacle_ == SyncObstacle::kNone; }
  [[nodiscard]] SyncObstacle obstacle() const { return obstacle_; }
  /// Without what the host does to single frames: the clocks have met.
  [[nodiscard]] bool schedule_in_sync() const { return schedule_in_sync_; }
  [[nodiscard]] bool too_late(Nanoseconds frame_error) const { return frame_error > settings_.late_allowed; }

 private:
  [[nodiscard]] SyncObstacle find(const Input& input) const;
  [[nodiscard]] bool within_settle(const std::optional<Nanoseconds>& since, Nanoseconds now) const {
    return since && now - *since < settings_.settle;
  }

  Settings settings_;
  Nanoseconds read_ = 0;
  std::optional<Nanoseconds> stepped_, skipped_, late_, distrusted_;
  SyncObstacle obstacle_ = SyncObstacle::kControlError;
  bool schedule_in_sync_ = false;
};

}  // namespace syncline::dc
