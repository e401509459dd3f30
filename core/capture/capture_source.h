// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "findings/finding.h"
#include "support/types.h"

namespace syncline {

/// What the frames of a capture prove of where they were captured: behind a switch, or in a virtual machine. In both
/// places times are not those of the wire. Feed it every frame of the capture, in order.
class CaptureSource {
 public:
  /// `frame`: from the Ethernet header on, as far as it was captured; `time`: ns, by whoever stamped it. False:
  /// it is the EtherCAT frame before it once more, which was on the wire once.
  bool add(std::span<const std::uint8_t> frame, Nanoseconds time);
  /// Warnings; none where nothing speaks for either.
  void tell(std::vector<Finding>& findings) const;

 private:
  std::uint64_t of_switches_ = 0;  // frames that switches send for themselves
  std::uint64_t tagged_ = 0;       // EtherCAT frames with an 802.1Q tag
  std::uint64_t twice_ = 0;        // EtherCAT frames that came twice
  std::uint64_t virtual_ = 0;      // EtherCAT frames that the adapter of a virtual machine sent
  std::array<std::uint8_t, 6> adapter_{};
  std::vector<std::uint8_t> before_;
  Nanoseconds time_before_ = 0;
};

}  // namespace syncline
