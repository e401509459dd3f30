// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace syncline::dc {

/// Why a slave had no new outputs in a SYNC0 period (a missed SM2 event), as far as the master knows.
enum class MissCause : std::uint8_t {
  kFrameLost,      // the frame with the outputs did not come back
  kCyclesLeftOut,  // the host sent none
  kFrameHeldUp,    // the frame was sent in time and held up on its way: not lost, and not the host's
  kFrameLate,      // the frame came, but behind the SYNC0 it was meant for
  kUnknown,        // the slave counts a miss where the master sees a good cycle
};
inline constexpr std::size_t kMissCauses = 5;
using MissesByCause = std::array<std::uint32_t, kMissCauses>;

}  // namespace syncline::dc
