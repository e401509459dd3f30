// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/sim_config.h"
#include "link/bus_responder.h"
#include "link/pcap_link.h"
#include "support/result.h"

namespace syncline {

struct SimulateRequest {
  std::string scenario;                   // TOML file
  std::string adapter;                    // "veth0"
  Nanoseconds duration = 0;               // 0: until stopped
  std::optional<std::uint64_t> seed;      // overrides the scenario's
  unsigned network = 0;                   // of a scenario with several
  Nanoseconds spin = 100 * kMicrosecond;  // see BusResponder::Options
  const std::atomic<bool>* stop = nullptr;
  /// Called once the bus answers, before the first frame is taken.
  std::function<void(const SimConfig& segment, const AdapterInfo& adapter)> on_ready;
};

struct SimulateReport {
  ResponderCounters counters;
  std::string refused;                      // real-time means that the system did not grant, in words
  Nanoseconds duration = 0;                 // that the bus was there
  std::vector<std::uint16_t> al_status;     // of every slave at the end, with the error bit
  std::vector<std::uint16_t> al_status_code;
};

/// Serves a scenario on a network adapter in real time, in the calling thread. kLinkNotFound, kLinkDown,
/// kLinkPermission and kLinkIo of the adapter; the scenario's errors.
[[nodiscard]] Result<SimulateReport> simulate_bus(const SimulateRequest& request);

}  // namespace syncline
