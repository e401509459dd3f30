// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

/// What the error counters of a port say of the frames that came in there, and where damage began.
namespace syncline {

/// Frames that were damaged in front of a port, out of its invalid frames (0x0300 + 2 p) and receive errors (0x0301 + 2
/// p; ESC data sheet II, 2.9): one is counted in both as a rule. Errors that were only forwarded (0x0308 + p) are
/// somebody else's.
[[nodiscard]] constexpr std::uint32_t damaged_frames(std::uint32_t invalid_frames, std::uint32_t receive_errors) {
  return std::max(invalid_frames, receive_errors);
}

struct DamagedPort {
  int slave = -1;  // position; -1: nowhere
  std::size_t port = 0;
  bool operator==(const DamagedPort&) const = default;
};

/// Where frames were damaged first: the first port in frame order for which `damaged(slave, port)` says so.
template <class Damaged>
[[nodiscard]] DamagedPort first_damaged_port(std::size_t slaves, const Damaged& damaged) {
  constexpr std::size_t kPortsOfEsc = 4;
  for (std::size_t slave = 0; slave < slaves; ++slave) {
    for (std::size_t port = 0; port < kPortsOfEsc; ++port) {
      if (damaged(slave, port)) return {static_cast<int>(slave), port};
    }
  }
  return {};
}

}  // namespace syncline
