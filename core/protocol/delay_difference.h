// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// Processing minus forwarding latency, ns (tDiff), of slaves nothing else is known of, where a frame leaves by a port
/// with a PHY; by E-bus (docs/distributed-clocks.md, Initialisation, says where the numbers come from).
inline constexpr std::uint32_t kUsualDelayDifference = 40;
inline constexpr std::uint32_t kEbusDelayDifference = 20;

}  // namespace syncline
