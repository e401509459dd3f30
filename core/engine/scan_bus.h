// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "master/scan/bus_scanner.h"
#include "support/result.h"

namespace syncline {

struct Event;
struct OpenedLink;

struct ScanRequest {
  ScanOptions options;
  std::function<void(const Event&)> on_event{};  // progress and warnings, while the scan runs
  const std::atomic<bool>* cancel = nullptr;
  std::string capture{};                                // pcapng file of every frame; "" for none
  std::function<void(const Error&)> on_capture_lost{};  // writing it failed; the scan goes on
};

/// Scans the bus in the calling thread and closes the link. Errors of `link` pass through.
[[nodiscard]] Result<BusScan> scan_bus(Result<OpenedLink> link, const ScanRequest& request = {});

}  // namespace syncline
