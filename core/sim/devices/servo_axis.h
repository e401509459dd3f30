// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <utility>

#include "support/types.h"

namespace syncline::sim {

/// Modes of operation that the simulated drives have (CiA 402, 0x6060).
enum class AxisMode : std::uint8_t {
  kNone = 0,
  kProfilePosition = 1,
  kInterpolatedPosition = 7,
  kCyclicPosition = 8,
  kCyclicVelocity = 9
};

/// Of object 0x6060; kNone for what the drives do not have.
[[nodiscard]] AxisMode axis_mode(std::uint8_t mode);
/// Targets come with each SYNC0.
[[nodiscard]] constexpr bool is_cyclic(AxisMode mode) {
  return mode == AxisMode::kCyclicPosition || mode == AxisMode::kCyclicVelocity;
}

/// What the process data and objects tell an axis. Positions in increments.
struct AxisCommand {
  AxisMode mode = AxisMode::kNone;
  std::uint16_t controlword = 0;
  std::int32_t target_position = 0;
  std::int32_t target_velocity = 0;  // increments/s
  std::int32_t interpolation_point = 0;
  std::uint32_t profile_velocity = 100'000;        // increments/s
  std::uint32_t profile_acceleration = 1'000'000;  // increments/s^2
  bool operator==(const AxisCommand&) const = default;
};

/// Demand generator and position loop of a drive: a proportional controller with velocity feed-forward on an axis that
/// follows its velocity with a lag of 0.5 ms. Smooth demands are followed within a few increments; a step of the
/// demand's velocity, as a missing target makes one, shows as following error. Times are true time.
class ServoAxis {
 public:
  /// Power on: holds its position.
  void enable(Nanoseconds time);
  void disable() {
    moved_ = moved_ || enabled_;
    enabled_ = false;
  }
  [[nodiscard]] bool enabled() const { return enabled_; }

  /// A new command is valid at `time`; it is meant for `cycle` ns (the distance of targets).
  void command(const AxisCommand& command, Nanoseconds time, Nanoseconds cycle);
  [[nodiscard]] const AxisCommand& last_command() const { return command_; }
  /// One servo period has come.
  void step(Nanoseconds time);

  /// True once after something that positions, velocity or target_reached() may have changed by.
  [[nodiscard]] bool take_moved() { return std::exchange(moved_, false); }
  [[nodiscard]] std::int32_t actual_position() const;
  [[nodiscard]] std::int32_t demand_position() const;
  [[nodiscard]] std::int32_t actual_velocity() const;
  [[nodiscard]] std::int32_t following_error() const;  // demand - actual
  [[nodiscard]] bool target_reached() const;
  [[nodiscard]] bool set_point_acknowledged() const { return acknowledged_; }
  /// Points that wait in the buffer of the interpolated position mode.
  [[nodiscard]] std::size_t points() const { return points_.size(); }

 private:
  static constexpr std::size_t kBuffer = 16;
  void set_mode(AxisMode mode);
  void start_segment(double target, Nanoseconds time, Nanoseconds length);
  [[nodiscard]] double demand_at(Nanoseconds time, double seconds);
  [[nodiscard]] double segment_at(Nanoseconds time) const;
  [[nodiscard]] double interpolate(Nanoseconds time);
  [[nodiscard]] double profile(double seconds);
  void take_set_point(const AxisCommand& command);
  void take_point(const AxisCommand& command);

  bool enabled_ = false, moved_ = true;
  AxisMode mode_ = AxisMode::kNone;
  AxisCommand command_;
  double demand_ = 0, actual_ = 0, velocity_ = 0;
  Nanoseconds last_step_ = 0;
  // Segment of the cyclic and interpolated modes:
  double from_ = 0, to_ = 0;
  Nanoseconds segment_start_ = 0, segment_length_ = 0;
  // Profile position:
  double goal_ = 0, profile_velocity_ = 0;
  bool acknowledged_ = false;
  // Interpolated position:
  std::deque<double> points_;
  bool running_ = false;
};

}  // namespace syncline::sim
