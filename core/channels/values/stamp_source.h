// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// Who says when a frame left, from the best that software can do on. The numbers stand in recordings.
enum class StampSource : std::uint8_t {
  kUntold = 0,
  kSoftware = 1,  // the master, just before it hands the frame to the link
  kKernel = 2,    // the kernel, when the driver got the frame (SO_TIMESTAMPING)
  kAdapter = 3,   // the network card, while it sends
  kCapture = 4,   // the host that captured the frame
  kProbe = 5,     // a probe on the wire, in hardware
};
inline constexpr int kStampSources = 6;

}  // namespace syncline
