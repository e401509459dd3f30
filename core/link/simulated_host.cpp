// SPDX-License-Identifier: Apache-2.0
#include "link/simulated_host.h"

#include "config/sim_config.h"
#include "link/simulated_link.h"
#include "support/clock.h"

namespace syncline {

void add_standstills(VirtualClock& clock, const SimConfig& config) {
  for (const auto& fault : config.faults) {
    if (fault.kind == FaultKind::kHostStall) clock.add_standstill(clock.now() + fault.at, fault.value_ns);
  }
}

SimulatedHost set_up_host(VirtualClock& clock, const SimConfig& config) {
  // Generators of their own, so that the host's jitter does not depend on the number of slaves.
  clock.set_wakeup_jitter(config.host_jitter, config.seed ^ 0x686F'7374'6A69'7474U);
  add_standstills(clock, config);
  auto host = SimulatedHost::with(config.host_jitter, config.seed ^ 0x7374'616D'7073ULL);
  for (const auto& fault : config.faults) {
    if (fault.kind == FaultKind::kCalendarStep) host.calendar_steps.push_back({clock.now() + fault.at, fault.value_ns});
  }
  host.adapter = AdapterFaults::of(config, clock.now());
  return host;
}

}  // namespace syncline
