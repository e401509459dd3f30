// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace syncline {

/// Where one variable of the process image stands that is watched: its bits, and the slave whose inputs they are.
struct WatchedPlace {
  bool output = false;
  std::uint32_t bit_offset = 0, bit_size = 0;  // of 1 to 64 bits, in that part of the image
  std::int32_t slave = -1;                     // position; inputs of one that does not exchange are not known; -1: none
  bool operator==(const WatchedPlace&) const = default;
};

/// So many variables at once.
inline constexpr std::size_t kMostWatched = 16;

/// Which variables go into each cycle's sample from now on, in place of those before; also while the bus is offline,
/// for the next time that it is not. What the image does not have is never known.
struct WatchCommand {
  std::uint32_t list = 0;  // number of this list, which the samples tell (CycleSample::watch_list); 0: of none
  std::uint8_t count = 0;  // places that are used
  std::array<WatchedPlace, kMostWatched> places{};
};

}  // namespace syncline
