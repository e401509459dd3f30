// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

#include "master/bus_scan.h"
#include "master/channels.h"
#include "support/result.h"

namespace syncline {

/// Opens `link`, scans the bus in the calling thread and closes it again. `on_event` sees the progress;
/// may be empty.
[[nodiscard]] Result<BusScan> scan_bus(std::string_view link, const std::function<void(const Event&)>& on_event = {});

}  // namespace syncline
