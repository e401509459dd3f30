// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <vector>

#include "compare/compare_configs.h"
#include "master/scan/bus_scanner.h"
#include "support/result.h"

namespace syncline {

struct NetworkConfig;
struct OpenedLink;

struct ComparedBus {
  std::vector<ConfigDifference> differences;  // left = configuration, right = bus
  std::vector<Finding> findings;              // of the scan: what could not be read
  std::size_t running = 0;                    // slaves in SAFEOP or OP, whose registers were compared, too
};

/// Scans the bus and compares it with a configuration. Errors as scan_bus().
[[nodiscard]] Result<ComparedBus> compare_bus(const NetworkConfig& config, Result<OpenedLink> link,
                                              const ScanOptions& options = {},
                                              const std::atomic<bool>* cancel = nullptr);

}  // namespace syncline
