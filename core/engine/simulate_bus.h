// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "link/bus_responder.h"
#include "support/result.h"

namespace syncline {

struct AdapterInfo;
struct SimConfig;

struct SimulateRequest {
  std::string adapter;                    // "veth0"
  Nanoseconds duration = 0;               // 0: until stopped
  Nanoseconds spin = 100 * kMicrosecond;  // see BusResponder::Options
  const std::atomic<bool>* stop = nullptr;
  /// Called once the bus answers, before the first frame is taken.
  std::function<void(const SimConfig& segment, const AdapterInfo& adapter)> on_ready;
};

struct SimulateReport {
  ResponderCounters counters;
  std::string refused;                   // real-time means that the system did not grant, in words
  Nanoseconds duration = 0;              // that the bus was there
  std::vector<std::uint16_t> al_status;  // of every slave at the end, with the error bit
  std::vector<std::uint16_t> al_status_code;
};

/// Serves a segment on a network adapter in real time, in the calling thread. kLinkNotFound, kLinkDown,
/// kLinkPermission and kLinkIo of the adapter; errors of `segment` pass through.
[[nodiscard]] Result<SimulateReport> simulate_bus(const Result<SimConfig>& segment, const SimulateRequest& request);

}  // namespace syncline
