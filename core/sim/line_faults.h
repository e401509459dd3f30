// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/segment.h"

namespace syncline::sim {

/// Frames that the lines of a segment lose or damage.
class LineFaults {
 public:
  static constexpr std::uint32_t kUntilRemoved = 0xFFFF'FFFF;
  /// Frames that do not arrive, or arrive damaged, at a port of a slave.
  struct Fault {
    std::uint16_t slave = 0;
    std::uint8_t port = 0;
    bool damaged = false;
    std::uint32_t frames = 0;
  };
  void add(const Fault& fault) { faults_.push_back(fault); }
  /// Ends those that are there until then.
  void remove(std::uint16_t slave, std::uint8_t port, bool damaged);

  /// So many frames of the master do not come to the first slave.
  void lose_frames(std::uint32_t count) { to_lose_ += count; }
  /// This is one of them.
  [[nodiscard]] bool takes_frame();

  /// How far a frame gets: receptions before the one at which it is lost, and the first one that is damaged; the number
  /// of all of them when neither happens.
  struct Reach {
    std::size_t end = 0, damaged = 0;
  };
  [[nodiscard]] Reach next_frame(std::span<const Passage> passages);

 private:
  std::vector<Fault> faults_;
  std::uint32_t to_lose_ = 0;
};

}  // namespace syncline::sim
