// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "support/types.h"

namespace syncline {

struct NetworkConfig;

/// Where a bridge device shows the time of another network: its "external synchronisation" object 0x10F4 (ETG.1020),
/// of which it maps both time stamps into the process data.
struct ExternalClockPlace {
  std::size_t slave = 0;
  std::size_t internal_byte = 0, external_byte = 0;  // in the image of the inputs, 8 bytes each
};
[[nodiscard]] std::optional<ExternalClockPlace> find_external_clock(const NetworkConfig& config);

/// Both of the same moment, ns since 2000 as far as either network knows it.
struct ExternalClockTimes {
  std::uint64_t internal = 0, external = 0;
  [[nodiscard]] Nanoseconds difference() const { return static_cast<Nanoseconds>(external - internal); }
};
/// Nothing while the bridge shows none (zero).
[[nodiscard]] std::optional<ExternalClockTimes> external_clock_times(const ExternalClockPlace& place,
                                                                     std::span<const std::uint8_t> inputs);

}  // namespace syncline
