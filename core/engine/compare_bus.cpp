// SPDX-License-Identifier: Apache-2.0
#include "engine/compare_bus.h"

#include <algorithm>
#include <utility>

#include "config/network_config.h"
#include "engine/open_bus.h"
#include "master/scan/bus_compare.h"
#include "master/scan/bus_scanner.h"

namespace syncline {

Result<ComparedBus> compare_bus(const NetworkConfig& config, Result<OpenedLink> link, const ScanOptions& options,
                                const std::atomic<bool>* cancel) {
  auto opened = OpenBus::open(std::move(link), cancel);
  if (!opened) return tl::unexpected(opened.error());
  Bus& bus = (*opened)->bus();
  const auto scan = scan_slaves(bus, options);
  if (!scan) return tl::unexpected(scan.error());
  const auto running = read_running_registers(bus, *scan);
  if (!running) return tl::unexpected(running.error());
  ComparedBus out;
  out.differences = compare_with_bus(config, *scan, *running);
  out.findings = scan->findings;
  out.running = static_cast<std::size_t>(
      std::ranges::count_if(*running, [](const auto& registers) { return registers.has_value(); }));
  return out;
}

}  // namespace syncline
