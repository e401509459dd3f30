// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "trace/sync_overview.h"

namespace syncline {

/// The overview of a recorded run at moments of it, so that none has to be made from the beginning on. Between two of
/// them lie kLeastBlocks blocks of the recording, or so many that there are kMost at most: some 50 KB each.
class OverviewMarks {
 public:
  static constexpr std::size_t kLeastBlocks = 8, kMost = 256;

  struct Mark {
    std::size_t blocks = 0, events = 0;  // that went into it
    OverviewRecorder overview;
  };

  /// Of a recording of so many blocks.
  explicit OverviewMarks(std::uint64_t blocks = 0);
  /// So many blocks and events have gone into it: kept where one is due. What lies before the last one is passed over.
  void pass(std::size_t blocks, std::size_t events, const OverviewRecorder& overview);
  /// The latest with so many blocks at most; null: none.
  [[nodiscard]] const Mark* at(std::size_t blocks) const;
  [[nodiscard]] std::size_t distance() const { return distance_; }

 private:
  std::size_t distance_;
  std::vector<Mark> marks_;  // by blocks
};

}  // namespace syncline
