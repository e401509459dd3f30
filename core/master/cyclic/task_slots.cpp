// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/task_slots.h"

#include <cstdlib>

namespace syncline {
namespace {

/// Towards negative infinity.
std::int64_t whole(std::int64_t value, std::int64_t unit) { return value / unit - (value % unit < 0 ? 1 : 0); }

}  // namespace

std::int64_t TaskSlots::next(std::int64_t left_out, std::optional<Nanoseconds> since_base) {
  number_ += 1 + left_out;
  // Where nobody keeps the frames at the grid they slide through it: they change their number once, not to and fro.
  if (since_base && std::abs(*since_base - number_ * cycle_time_) > cycle_time_ * 3 / 4)
    number_ = whole(*since_base + cycle_time_ / 2, cycle_time_);
  return number_;
}

bool TaskTurn::take(std::int64_t slot) {
  const auto turn = whole(slot, every_);
  if (every_ > 1 && turn == turn_) return false;
  turn_ = turn;
  return true;
}

}  // namespace syncline
