// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "app/cli/context.h"
#include "app/cli/duration.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/run_json.h"
#include "app/composition/load_scenario.h"
#include "config/sim_config.h"
#include "engine/simulate_bus.h"
#include "findings/fold.h"
#include "link/pcap_link.h"
#include "protocol/al_state.h"
#include "sim/faults/fault_rules.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

struct SimulateOptions {
  std::string scenario, adapter, duration;
  std::uint64_t seed = 0;
  unsigned network = 0;
  bool has_seed = false, json = false;
  double spin_us = 100;
};

std::string name_of(const SimSlaveConfig& slave) { return slave.name.empty() ? slave.device.type : slave.name; }

void print_served(std::ostream& out, const SimConfig& segment, const AdapterInfo& adapter) {
  out << fmt::format("serving {} on {} ({}), {}\n", segment.name, adapter.name, mac_text(adapter.mac),
                     counted(segment.slaves.size(), "slave"));
  out << fmt::format("{:>3} {:<20} {:<32} {:>6} {}\n", "POS", "NAME", "VENDOR:PRODUCT:REVISION", "ALIAS", "BEHIND");
  for (std::size_t i = 0; i < segment.slaves.size(); ++i) {
    const auto& slave = segment.slaves[i];
    const auto behind = slave.parent ? fmt::format("{} port {}", *slave.parent,
                                                   std::string(1, static_cast<char>('A' + slave.parent_port)))
                                     : std::string("master");
    out << fmt::format("{:>3} {:<20} {:<32} {:>6} {}\n", i, name_of(slave), to_string(slave.device.identity),
                       slave.alias, behind);
  }
  if (const auto faults = sim::host_faults(segment); !faults.empty())
    out << fmt::format("passed over, because the host is the master's own: {}\n", fmt::join(faults, ", "));
  out.flush();
}

Json served_json(const SimConfig& segment, const AdapterInfo& adapter) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < segment.slaves.size(); ++i) {
    const auto& slave = segment.slaves[i];
    rows.push_back({{"position", i},
                    {"name", name_of(slave)},
                    {"vendor_id", hex(slave.device.identity.vendor_id, 8)},
                    {"product_code", hex(slave.device.identity.product_code, 8)},
                    {"revision_no", hex(slave.device.identity.revision_no, 8)},
                    {"serial_no", slave.serial_no},
                    {"alias", slave.alias}});
  }
  return {{"scenario", segment.name},
          {"adapter", adapter.name},
          {"mac", mac_text(adapter.mac)},
          {"slaves", rows},
          {"host_faults", sim::host_faults(segment)}};
}

double microseconds(Nanoseconds time) { return static_cast<double>(time) / 1'000.0; }

void print_summary(std::ostream& out, const SimulateReport& report) {
  const auto& counters = report.counters;
  out << fmt::format("served {} ({}) in {:.1f} s; {} did not come back, {} dropped by the kernel\n",
                     counted(counters.frames, "frame"), counted(counters.bytes, "byte"),
                     static_cast<double>(report.duration) / 1e9, counters.lost, counters.dropped);
  out << fmt::format("service time per frame: p50 {:.1f} us, p99 {:.1f} us, largest {:.1f} us\n",
                     microseconds(counters.service_quantile(0.5)), microseconds(counters.service_quantile(0.99)),
                     microseconds(counters.longest_service));
  if (!report.refused.empty()) {
    out << fmt::format("answers may have been late: {}; this grants it: {}\n", report.refused, permission_command());
  }
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::vector<int>> left;  // by AL status and its code
  for (std::size_t i = 0; i < report.al_status.size(); ++i) {
    if ((report.al_status[i] & kAlErrorFlag) != 0)
      left[{report.al_status[i], report.al_status_code[i]}].push_back(static_cast<int>(i));
  }
  for (const auto& [state, slaves] : left) {
    const bool one = slaves.size() == 1;
    out << fmt::format("{} {} {} left in {} with AL status code 0x{:04X}: {}\n", one ? "slave" : "slaves",
                       ranges_text(slaves), one ? "is" : "are", state_text(state.first), state.second,
                       al_status_code_text(state.second).meaning);
  }
}

Json summary_json(const SimulateReport& report) {
  const auto& counters = report.counters;
  Json states = Json::array();
  for (std::size_t i = 0; i < report.al_status.size(); ++i) {
    states.push_back({{"position", i},
                      {"state", state_text(report.al_status[i])},
                      {"al_status_code", hex(report.al_status_code[i], 4)}});
  }
  return {{"duration_s", static_cast<double>(report.duration) / 1e9},
          {"frames", counters.frames},
          {"bytes", counters.bytes},
          {"lost", counters.lost},
          {"dropped", counters.dropped},
          {"service_p50_us", microseconds(counters.service_quantile(0.5))},
          {"service_p99_us", microseconds(counters.service_quantile(0.99))},
          {"service_max_us", microseconds(counters.longest_service)},
          {"refused", report.refused},
          {"states", states}};
}

void simulate(Context& context, const SimulateOptions& options) {
  SimulateRequest request;
  request.adapter = options.adapter;
  request.spin = static_cast<Nanoseconds>(options.spin_us * 1'000);
  const auto seed = options.has_seed ? std::optional(options.seed) : std::nullopt;
  if (!options.duration.empty()) {
    const auto duration = parse_duration(options.duration);
    if (!duration) return context.fail_with(duration.error());
    request.duration = *duration;
  }
  Json result;
  request.on_ready = [&](const SimConfig& segment, const AdapterInfo& adapter) {
    if (options.json) {
      result = served_json(segment, adapter);
    } else {
      print_served(context.console.out, segment, adapter);
    }
  };
  const InterruptGuard guard;
  request.stop = &guard.interrupted();
  const auto report = simulate_bus(load_network(options.scenario, options.network, seed), request);
  if (!report) return context.fail_with(report.error());
  if (options.json) {
    result["summary"] = summary_json(*report);
    context.print(result);
  } else {
    print_summary(context.console.out, *report);
  }
}

}  // namespace

void add_simulate_command(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "simulate", "Be a bus: answer EtherCAT frames of any master on a network adapter with a simulated segment");
  auto options = std::make_shared<SimulateOptions>();
  command->add_option("scenario", options->scenario, "Scenario file (TOML)")->required();
  command->add_option("--nic", options->adapter, "Network adapter, e.g. one end of a veth pair")->required();
  command->add_option("--for", options->duration, "How long, e.g. 20s; without it until Ctrl-C");
  auto* seed = command->add_option("--seed", options->seed, "Seed instead of the scenario's");
  command->add_option("--network", options->network, "Which, of a scenario with several networks, from 0");
  command
      ->add_option("--spin-us", options->spin_us, "Look for the next frame this long before sleeping; 0 always sleeps")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON at the end");
  command->callback([&context, options, seed] {
    options->has_seed = seed->count() > 0;
    simulate(context, *options);
  });
}

}  // namespace syncline::cli
