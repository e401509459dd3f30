// SPDX-License-Identifier: Apache-2.0
#include "app/composition/open_link.h"

#include <utility>

#include "app/composition/link_text.h"
#include "app/composition/load_scenario.h"
#include "capture/replay_link.h"
#include "config/project.h"
#include "config/sim_config.h"
#include "engine/opened_link.h"
#include "link/pcap_link.h"
#include "link/simulated_host.h"
#include "link/simulated_link.h"
#include "recover/simulated_network.h"
#include "sim/sim_bus.h"

namespace syncline {
namespace {

Result<OpenedLink> simulated_link(const SimConfig& config, const std::string& name, bool virtual_clock) {
  OpenedLink opened;
  SimulatedHost host;  // a real host has errors of its own
  if (virtual_clock) {
    auto clock = std::make_unique<VirtualClock>();
    host = set_up_host(*clock, config);
    opened.clock = std::move(clock);
  } else {
    opened.clock = std::make_unique<RealClock>();
    host.adapter = AdapterFaults::of(config, opened.clock->now());
  }
  auto bus = sim::SimBus::create(config, opened.clock->now());
  if (!bus) return tl::unexpected(bus.error());
  opened.link = make_simulated_link("sim:" + name, std::move(*bus), *opened.clock, host);
  return opened;
}

}  // namespace

Result<OpenedLink> open_simulated(const Project& machine) {
  auto config = simulated_network(machine);
  config.host_jitter = JitterProfile::quiet();  // what is in sync only with a perfect host is not in sync
  return simulated_link(config, machine.name, true);
}

Result<OpenedLink> open_link(std::string_view text) {
  const auto parsed = parse_link_text(text);
  if (!parsed) return tl::unexpected(parsed.error());
  switch (parsed->kind) {
    case LinkKind::kSimulated: {
      const auto config = load_network(parsed->target, parsed->network, parsed->seed);
      if (!config) return tl::unexpected(config.error());
      return simulated_link(*config, parsed->target, parsed->virtual_clock);
    }
    case LinkKind::kAdapter: {
      OpenedLink opened;
      opened.clock = std::make_unique<RealClock>();
      auto link = open_pcap_link(parsed->target, *opened.clock);
      if (!link) return tl::unexpected(link.error());
      opened.link = std::move(*link);
      return opened;
    }
    case LinkKind::kReplay: {
      OpenedLink opened;
      auto clock = std::make_unique<VirtualClock>();
      auto notes = std::make_shared<ReplayNotes>();
      auto link = make_replay_link(parsed->target, *clock, notes.get());
      if (!link) return tl::unexpected(link.error());
      opened.clock = std::move(clock);
      opened.link = std::move(*link);
      opened.replay = std::move(notes);
      return opened;
    }
  }
  return fail(ErrorCode::kBadValue, std::string(text));
}

}  // namespace syncline
