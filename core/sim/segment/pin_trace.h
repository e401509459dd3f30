// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

#include "support/types.h"

namespace syncline::sim {

/// An edge of a device's output pin, as an oscilloscope would see it; true time.
struct PinEdge {
  Nanoseconds time = 0;
  bool level = false;
  bool operator==(const PinEdge&) const = default;
};

/// The last edges of an output pin.
class PinTrace {
 public:
  static constexpr std::size_t kEdges = 65'536;

  void pulse(Nanoseconds begin, Nanoseconds end) {
    if (!edges_.empty() && edges_.back().time >= begin) edges_.back().time = begin - 1;  // pulses do not overlap
    edges_.push_back({begin, true});
    edges_.push_back({std::max(end, begin + 1), false});
    while (edges_.size() > kEdges) edges_.pop_front();
  }
  [[nodiscard]] std::vector<PinEdge> edges() const { return {edges_.begin(), edges_.end()}; }
  void clear() { edges_.clear(); }

 private:
  std::deque<PinEdge> edges_;
};

}  // namespace syncline::sim
