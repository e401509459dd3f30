// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "support/random.h"

namespace syncline::sim {

struct Passage;

/// Frames that the lines of a segment lose or damage. What happens by chance is the same for the same seed.
class LineFaults {
 public:
  static constexpr std::uint32_t kUntilRemoved = 0xFFFF'FFFF;
  static constexpr int kAnywhere = -1;

  /// `loss`: probability that a frame is lost, anywhere on its way.
  LineFaults(double loss, std::uint64_t seed) : random_(seed), loss_(loss) {}

  /// Frames that do not arrive, or arrive damaged, at a port of a slave; or anywhere.
  struct Fault {
    int slave = kAnywhere;
    std::uint8_t port = 0;
    bool damaged = false;
    std::uint32_t frames = 0;
    double probability = 1;
    bool operator==(const Fault&) const = default;
  };
  void add(const Fault& fault) { faults_.push_back(fault); }
  /// Ends one that lasts until then.
  void remove(const Fault& fault);

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
  [[nodiscard]] bool happens(double probability) { return probability >= 1 || random_.uniform() < probability; }
  [[nodiscard]] std::size_t somewhere(std::size_t receptions);

  std::vector<Fault> faults_;
  std::uint32_t to_lose_ = 0;
  Random random_;
  double loss_;
};

}  // namespace syncline::sim
