// SPDX-License-Identifier: Apache-2.0
#include "engine/simulate_bus.h"

#include "config/sim_config.h"
#include "link/raw_port.h"
#include "protocol/registers.h"
#include "sim/sim_bus.h"
#include "support/byte_order.h"
#include "support/clock.h"
#include "support/real_time.h"

namespace syncline {
namespace {

/// Below a master's cyclic thread on the same machine: an answer may come a little later, a frame must not leave late
/// because of us.
constexpr int kPriority = RealTimeScope::kDefaultPriority - 5;

std::uint16_t peek16(const sim::SimBus& bus, std::size_t position, std::uint16_t address) {
  return load_le<std::uint16_t>(bus.peek(position, address, 2));
}

}  // namespace

Result<SimulateReport> simulate_bus(const Result<SimConfig>& segment, const SimulateRequest& request) {
  if (!segment) return tl::unexpected(segment.error());
  RealClock clock;
  auto port = RawPort::open(request.adapter, clock);
  if (!port) return tl::unexpected(port.error());
  const auto start = clock.now();
  auto bus = sim::SimBus::create(*segment, start);
  if (!bus) return tl::unexpected(bus.error());

  const RealTimeScope real_time(kPriority);
  BusResponder responder(**bus, *port, clock, {request.spin});
  if (request.on_ready) request.on_ready(*segment, port->adapter());
  const std::atomic<bool> never{false};
  const auto end = request.duration > 0 ? clock.now() + request.duration : 0;
  const auto served = responder.serve(end, request.stop != nullptr ? *request.stop : never);
  if (!served) return tl::unexpected(served.error());

  SimulateReport report;
  report.refused = real_time.refused();
  report.counters = responder.counters();
  report.duration = clock.now() - start;
  for (std::size_t i = 0; i < (*bus)->slave_count(); ++i) {
    report.al_status.push_back(peek16(**bus, i, reg::kAlStatus));
    report.al_status_code.push_back(peek16(**bus, i, reg::kAlStatusCode));
  }
  return report;
}

}  // namespace syncline
