// SPDX-License-Identifier: Apache-2.0
#include "record/overview_marks.h"

#include <algorithm>
#include <iterator>

namespace syncline {

OverviewMarks::OverviewMarks(std::uint64_t blocks)
    : distance_(std::max(kLeastBlocks, static_cast<std::size_t>(blocks) / kMost + 1)) {}

void OverviewMarks::pass(std::size_t blocks, std::size_t events, const OverviewRecorder& overview) {
  if (blocks == 0 || blocks % distance_ != 0) return;
  if (!marks_.empty() && blocks <= marks_.back().blocks) return;
  marks_.push_back({blocks, events, overview});
}

const OverviewMarks::Mark* OverviewMarks::at(std::size_t blocks) const {
  const auto behind = std::ranges::upper_bound(marks_, blocks, {}, &Mark::blocks);
  return behind == marks_.begin() ? nullptr : &*std::prev(behind);
}

}  // namespace syncline
