// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/servo_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace syncline::sim {
namespace {

constexpr double kLag = 0.5e-3;                       // s, of the velocity behind its command
constexpr double kGain = 100;                         // 1/s, position loop
constexpr double kWindow = 2;                         // increments, target reached
constexpr std::uint16_t kNewSetPoint = 0x10;          // controlword, profile position
constexpr std::uint16_t kEnableInterpolation = 0x10;  // controlword, interpolated position

double seconds_of(Nanoseconds time) { return static_cast<double>(time) * 1e-9; }

std::int32_t increments(double value) {
  constexpr double kLowest = std::numeric_limits<std::int32_t>::min(),
                   kHighest = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::lround(std::clamp(value, kLowest, kHighest)));
}

}  // namespace

AxisMode axis_mode(std::uint8_t mode) {
  switch (const auto wanted = static_cast<AxisMode>(mode)) {
    case AxisMode::kProfilePosition:
    case AxisMode::kInterpolatedPosition:
    case AxisMode::kCyclicPosition:
    case AxisMode::kCyclicVelocity:
      return wanted;
    default:
      return AxisMode::kNone;
  }
}

void ServoAxis::enable(Nanoseconds time) {
  enabled_ = moved_ = true;
  velocity_ = 0;
  demand_ = actual_;
  last_step_ = time;
  mode_ = AxisMode::kNone;
  set_mode(command_.mode);
}

void ServoAxis::set_mode(AxisMode mode) {
  mode_ = mode;
  goal_ = from_ = to_ = demand_;
  segment_length_ = 0;
  profile_velocity_ = 0;
  acknowledged_ = running_ = false;
  points_.clear();
}

void ServoAxis::command(const AxisCommand& command, Nanoseconds time, Nanoseconds cycle) {
  const auto previous = command_;
  command_ = command;
  if (!enabled_) return;
  moved_ = true;
  if (command.mode != mode_) set_mode(command.mode);
  switch (mode_) {
    case AxisMode::kCyclicPosition:
      return start_segment(command.target_position, time, cycle);
    case AxisMode::kInterpolatedPosition:
      segment_length_ = cycle;
      return take_point(command);
    case AxisMode::kProfilePosition:
      // The set-point is taken with the edge, however late the frame that brings it.
      if ((command.controlword & ~previous.controlword & kNewSetPoint) != 0) take_set_point(command);
      acknowledged_ = acknowledged_ && (command.controlword & kNewSetPoint) != 0;
      return;
    default:
      return;
  }
}

void ServoAxis::start_segment(double target, Nanoseconds time, Nanoseconds length) {
  from_ = segment_at(time);
  to_ = target;
  segment_start_ = time;
  segment_length_ = length;
}

double ServoAxis::segment_at(Nanoseconds time) const {
  if (segment_length_ <= 0) return to_;
  const double part = static_cast<double>(time - segment_start_) / static_cast<double>(segment_length_);
  return from_ + (to_ - from_) * std::clamp(part, 0.0, 1.0);
}

void ServoAxis::take_set_point(const AxisCommand& command) {
  constexpr std::uint16_t kRelative = 0x40;
  goal_ = command.target_position + ((command.controlword & kRelative) != 0 ? goal_ : 0);
  acknowledged_ = true;
}

void ServoAxis::take_point(const AxisCommand& command) {
  if ((command.controlword & kEnableInterpolation) == 0) {
    running_ = false;
    points_.clear();
    return;
  }
  if (points_.size() < kBuffer) points_.push_back(command.interpolation_point);
}

/// A point each segment length of the drive's own time, once half the buffer is full.
double ServoAxis::interpolate(Nanoseconds time) {
  if (!running_) {
    if (points_.size() < kBuffer / 2) return demand_;
    running_ = true;
    from_ = to_ = demand_;
    segment_start_ = time - segment_length_;
  }
  while (running_ && time - segment_start_ >= segment_length_) {
    if (points_.empty()) {
      running_ = false;  // underrun: collects anew
      return to_;
    }
    from_ = to_;
    to_ = points_.front();
    points_.pop_front();
    segment_start_ += segment_length_;
    // The master's clock and ours differ: a little faster or slower keeps the buffer half full.
    const auto fill = static_cast<Nanoseconds>(points_.size()) - static_cast<Nanoseconds>(kBuffer / 2);
    segment_start_ -= fill * segment_length_ / 10'000;
  }
  return segment_at(time);
}

/// Trapezoidal profile towards the goal.
double ServoAxis::profile(double seconds) {
  const double distance = goal_ - demand_;
  const double acceleration = std::max(1.0, static_cast<double>(command_.profile_acceleration));
  const double reachable = std::sqrt(2 * acceleration * std::abs(distance));
  const double wanted = std::copysign(std::min<double>(command_.profile_velocity, reachable), distance);
  const double change = acceleration * seconds;
  profile_velocity_ += std::clamp(wanted - profile_velocity_, -change, change);
  const double next = demand_ + profile_velocity_ * seconds;
  if (std::abs(distance) <= std::abs(profile_velocity_ * seconds) || std::abs(distance) < 0.5) {
    profile_velocity_ = 0;
    return goal_;
  }
  return next;
}

double ServoAxis::demand_at(Nanoseconds time, double seconds) {
  switch (mode_) {
    case AxisMode::kCyclicPosition:
      return segment_at(time);
    case AxisMode::kInterpolatedPosition:
      return segment_length_ > 0 ? interpolate(time) : demand_;
    case AxisMode::kProfilePosition:
      return profile(seconds);
    case AxisMode::kCyclicVelocity:
      return demand_ + command_.target_velocity * seconds;
    case AxisMode::kNone:
      break;
  }
  return demand_;
}

void ServoAxis::step(Nanoseconds time) {
  if (!enabled_ || time <= last_step_) return;
  moved_ = true;
  const double seconds = seconds_of(time - last_step_);
  last_step_ = time;
  const double demand = demand_at(time, seconds);
  const double feed_forward = (demand - demand_) / seconds;
  demand_ = demand;
  actual_ += velocity_ * seconds;
  const double wanted = feed_forward + kGain * (demand_ - actual_);
  velocity_ += (wanted - velocity_) * (1 - std::exp(-seconds / kLag));
}

std::int32_t ServoAxis::actual_position() const { return increments(actual_); }
std::int32_t ServoAxis::demand_position() const { return increments(demand_); }
std::int32_t ServoAxis::actual_velocity() const { return increments(velocity_); }
std::int32_t ServoAxis::following_error() const { return enabled_ ? increments(demand_ - actual_) : 0; }
bool ServoAxis::target_reached() const { return std::abs(goal_ - actual_) <= kWindow && profile_velocity_ == 0; }

}  // namespace syncline::sim
