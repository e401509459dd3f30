// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "master/bus.h"
#include "master/bus_scan.h"

namespace syncline {

/// Slaves done and slaves found.
using ScanProgress = std::function<void(std::size_t done, std::size_t found)>;

/// First station address that the scan gives; the configurator's convention.
inline constexpr std::uint16_t kFirstStationAddress = 1001;

/// Number of slaves that process a broadcast; 0 when no frame comes back from any.
[[nodiscard]] Result<std::uint16_t> count_slaves(Bus& bus);

/// Finds every slave, gives it a station address (1001 onwards) and reads who it is, where it hangs
/// and what its clock can do. States are left as they are. kNoResponse on an empty or dead bus.
[[nodiscard]] Result<BusScan> scan_slaves(Bus& bus, const ScanProgress& progress = {});

/// What the clocks can do, by asking (feature bits lie): for each station address.
[[nodiscard]] Result<std::vector<DcCapability>> probe_dc(Bus& bus, std::span<const std::uint16_t> stations);

}  // namespace syncline
