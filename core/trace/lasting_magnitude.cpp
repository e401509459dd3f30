// SPDX-License-Identifier: Apache-2.0
#include "trace/lasting_magnitude.h"

#include "dc/dcm/sync_judge.h"

namespace syncline {

void LastingMagnitude::add(Nanoseconds time, std::int64_t magnitude) {
  auto since = time;
  for (; !levels_.empty() && levels_.back().magnitude >= magnitude; levels_.pop_back()) since = levels_.back().since;
  levels_.push_back({since, magnitude});
  const auto lasted = [time](const Level& level) { return time - level.since >= dc::SyncJudge::kPatience; };
  while (levels_.size() > 1 && lasted(levels_[1])) levels_.pop_front();
  const auto& longest = levels_.front();
  if (!lasted(longest) || (largest_ && longest.magnitude <= largest_->magnitude)) return;
  largest_ = {time, longest.magnitude};
}

void LastingMagnitude::clear() {
  levels_.clear();
  largest_.reset();
}

std::optional<double> LastingMagnitude::margin(std::int64_t limit) const {
  if (limit <= 0 || !largest_) return std::nullopt;
  return 1 - static_cast<double>(largest_->magnitude) / static_cast<double>(limit);
}

}  // namespace syncline
