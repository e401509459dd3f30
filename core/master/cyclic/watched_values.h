// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "channels/watch_command.h"
#include "master/cyclic/cyclic_frame_set.h"

namespace syncline {

struct CycleSample;
struct Snapshot;

/// Copies the variables that somebody watches out of the process image into the sample of each cycle. An input is known
/// when the datagrams that read it came back with the expected working counter, and its slave exchanges process data;
/// an output when it is sent: it is the master's own. Of a slower task both are what they were when it was due last.
/// Allocates nothing; the cyclic thread.
class WatchedValues {
 public:
  WatchedValues(const CyclicFrameSet& frames, const Snapshot& snapshot) : frames_(frames), snapshot_(snapshot) {}
  WatchedValues(const WatchedValues&) = delete;
  WatchedValues& operator=(const WatchedValues&) = delete;

  /// From the next cycle on.
  void watch(const WatchCommand& command);
  /// Behind prepare(), while the image holds what the frames carry.
  void take_outputs();
  /// Behind the answers of the cycle.
  void fill(CycleSample& sample) const;

 private:
  static constexpr std::size_t kMostCarriers = 8;  // a variable lies in one, or at the edge of two
  struct Place {
    WatchedPlace what;
    std::array<CyclicFrameSet::Carrier, kMostCarriers> carriers{};
    std::uint8_t carrier_count = 0;
    std::uint16_t all_bytes = 0;  // that it touches; 0: the image has no such place
    std::uint64_t sent = 0;       // of an output, when it went out last
    bool was_sent = false;
  };

  template <class Counts>
  [[nodiscard]] bool covered(const Place& place, Counts counts) const;
  [[nodiscard]] bool exchanges(const Place& place) const;

  const CyclicFrameSet& frames_;
  const Snapshot& snapshot_;
  std::uint32_t list_ = 0;
  std::size_t count_ = 0;
  std::array<Place, kMostWatched> places_{};
};

}  // namespace syncline
