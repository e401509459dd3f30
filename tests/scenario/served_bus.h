// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "app/composition/load_scenario.h"
#include "config/sim_config.h"
#include "engine/simulate_bus.h"
#include "link/pcap_link.h"
#include "support/net_namespace.h"

namespace syncline::test {

/// Serves a scenario on the bus's end of the pair until it is destroyed.
class ServedBus {
 public:
  explicit ServedBus(const std::string& scenario) {
    request_.adapter = NetNamespace::kBusEnd;
    request_.stop = &stop_;
    request_.on_ready = [this](const SimConfig&, const AdapterInfo&) { ready_ = true; };
    thread_ = std::thread([this, scenario] {
      report_ = simulate_bus(load_network(scenario, 0, {}), request_);
      ended_ = true;
    });
    while (!ready_ && !ended_) std::this_thread::yield();
  }
  ~ServedBus() { (void)finish(); }
  ServedBus(const ServedBus&) = delete;
  ServedBus& operator=(const ServedBus&) = delete;

  Result<SimulateReport> finish() {
    stop_ = true;
    return wait();
  }
  /// For a service that ends by itself.
  Result<SimulateReport> wait() {
    if (thread_.joinable()) thread_.join();
    return report_;
  }

 private:
  SimulateRequest request_;
  std::atomic<bool> stop_{false}, ready_{false}, ended_{false};
  Result<SimulateReport> report_;
  std::thread thread_;
};

}  // namespace syncline::test
