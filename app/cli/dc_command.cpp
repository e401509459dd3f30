// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/cli/context.h"
#include "app/cli/findings_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/composition/load_config.h"
#include "app/composition/open_link.h"
#include "channels/event_finding.h"
#include "engine/open_bus.h"
#include "master/clocks/clock_survey.h"
#include "master/clocks/dc_setup.h"
#include "master/scan/bus_scanner.h"
#include "protocol/assign_activate.h"

namespace syncline::cli {
namespace {

struct DcOptions {
  std::string link, file, network;
  bool json = false, look_only = false;
  std::size_t rounds = 20;
};

/// The slaves behind a link by their places, and their names where a configuration says them.
struct Segment {
  std::unique_ptr<OpenBus> open;
  std::vector<SlaveAddress> addresses;
  std::optional<NetworkConfig> config;

  [[nodiscard]] std::string name(std::size_t slave) const {
    return config && slave < config->slaves.size() ? config->slaves[slave].name : fmt::format("slave {}", slave);
  }
};

Result<Segment> open_segment(const DcOptions& options, const InterruptGuard& interrupt) {
  Segment segment;
  if (!options.file.empty()) {
    auto compiled = load_config(options.file, {}, options.network);
    if (!compiled) return tl::unexpected(compiled.error());
    segment.config = std::move(compiled->config);
  }
  auto open = OpenBus::open(open_link(options.link), &interrupt.interrupted());
  if (!open) return tl::unexpected(open.error());
  segment.open = std::move(*open);
  const auto count = count_slaves(segment.open->bus());
  if (!count) return tl::unexpected(count.error());
  if (*count == 0) return fail(ErrorCode::kNoResponse, options.link);
  if (segment.config && segment.config->slaves.size() != *count) {
    Error error{ErrorCode::kSlaveCount, options.link};
    error.expected = static_cast<std::int64_t>(segment.config->slaves.size());
    error.received = *count;
    return fail(std::move(error));
  }
  for (std::uint16_t i = 0; i < *count; ++i) segment.addresses.push_back(SlaveAddress::at_position(i));
  return segment;
}

std::string_view capability_text(DcCapability capability) {
  switch (capability) {
    case DcCapability::kNone:
      return "none";
    case DcCapability::kReceiveTimesOnly:
      return "receive times";
    case DcCapability::kSystemTime32:
      return "32 bit";
    case DcCapability::kSystemTime64:
      return "64 bit";
  }
  return "none";
}

/// What is not as configured; empty when all is, or when nothing is configured.
std::string deviation_from(const std::optional<NetworkConfig>& config, std::size_t slave, const ClockReading& clock) {
  if (clock.start_missed()) return "SYNC0 will never come: its start time has passed";
  const bool active = AssignActivate{clock.assign_activate}.unit_on();
  if (!config || !config->slaves[slave].dc || !active) return {};
  const auto& dc = *config->slaves[slave].dc;
  if (dc.cycle_time0 != clock.sync0_cycle_ns) {
    return fmt::format("SYNC0 cycle {} ns, configured are {} ns", clock.sync0_cycle_ns, dc.cycle_time0);
  }
  return dc.assign_activate == clock.assign_activate ? std::string()
                                                     : fmt::format("activated with 0x{:04x}, configured is 0x{:04x}",
                                                                   clock.assign_activate, dc.assign_activate);
}

void print_status(Context& context, const Segment& segment, const std::vector<ClockReading>& clocks, bool json) {
  int reference = -1;
  if (const auto clock = segment.config ? configured_reference_clock(*segment.config) : std::nullopt)
    reference = *clock;
  Json rows = Json::array();
  if (!json) {
    context.console.out << fmt::format("{:>3} {:<24} {:<13} {:>20} {:>10} {:>9} {:>9} {:>6} {:<22}\n", "POS", "NAME",
                                       "CLOCK", "SYSTEM TIME ns", "DELAY ns", "DIFF ns", "LOOP ppm", "SYNC",
                                       "SYNC0 CYCLE ns");
  }
  for (std::size_t i = 0; i < clocks.size(); ++i) {
    const auto& clock = clocks[i];
    const AssignActivate activate{clock.assign_activate};
    const auto wrong = deviation_from(segment.config, i, clock);
    if (!wrong.empty()) context.exit_code = kAnswerIsNo;
    if (json) {
      Json row{{"position", i},
               {"name", segment.name(i)},
               {"clock", capability_text(clock.capability)},
               {"reference_clock", reference == static_cast<int>(i)}};
      if (clock.has_system_time()) {
        row["system_time_ns"] = clock.system_time;
        row["offset_ns"] = clock.offset;
        row["delay_ns"] = clock.delay_ns;
        row["difference_ns"] = clock.difference_ns;
        row["speed_counter_start"] = clock.speed_counter_start;
        row["speed_counter_difference"] = clock.speed_counter_diff;
        row["correction_ppm"] = clock.correction_ppm();
        row["filter_depth_difference"] = clock.filter_depth_difference;
        row["filter_depth_speed_counter"] = clock.filter_depth_speed_counter;
        row["assign_activate"] = hex(clock.assign_activate, 4);
        row["start_pending"] = clock.start_pending;
        row["next_sync0_ns"] = clock.next_sync0;
        row["sync0_cycle_ns"] = clock.sync0_cycle_ns;
        row["sync1_cycle_ns"] = clock.sync1_cycle_ns;
      }
      row["wrong"] = wrong.empty() ? Json(nullptr) : Json(wrong);
      rows.push_back(std::move(row));
      continue;
    }
    auto& out = context.console.out;
    const auto name = segment.name(i) + (reference == static_cast<int>(i) ? " (ref)" : "");
    out << fmt::format("{:>3} {:<24} {:<13} ", i, name, capability_text(clock.capability));
    if (clock.has_system_time()) {
      const auto sync = !activate.unit_on() ? "off" : clock.start_pending ? "waits" : activate.sync1() ? "0+1" : "0";
      out << fmt::format("{:>20} {:>10} {:>9} {:>9.3f} {:>6} {:<22}", clock.system_time, clock.delay_ns,
                         clock.difference_ns, clock.correction_ppm(), sync, clock.sync0_cycle_ns);
    }
    out << (wrong.empty() ? "" : " " + wrong) << '\n';
  }
  if (json) context.print({{"slaves", rows}});
}

void show_status(Context& context, const DcOptions& options) {
  const InterruptGuard interrupt;
  auto segment = open_segment(options, interrupt);
  if (!segment) return context.fail_with(segment.error());
  const auto clocks = survey_clocks(segment->open->bus(), segment->addresses);
  if (!clocks) return context.fail_with(clocks.error());
  print_status(context, *segment, *clocks, options.json);
}

void print_delays(Context& context, const Segment& segment, const DelaySurvey& survey, bool json) {
  const auto& nodes = survey.segment.nodes;
  Json rows = Json::array();
  if (!json) {
    context.console.out << fmt::format("{:>3} {:<24} {:<13} {:>5} {:>8} {:>8} {:>8} {:>9}\n", "POS", "NAME", "CLOCK",
                                       "ENTRY", "3 (D)", "1 (B)", "2 (C)", "DELAY ns");
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& node = nodes[i];
    const auto entry = survey.result.entry_port[i];
    const auto delay = survey.result.delay_ns[i];
    const auto away = [&](unsigned port) -> std::optional<std::int32_t> {
      if (node.kind == dc::DcKind::kNone || !node.active[port] || port == entry) return std::nullopt;
      return static_cast<std::int32_t>(node.receive_time[port] - node.receive_time[entry]);
    };
    if (json) {
      Json ports = Json::array();
      for (unsigned port = 0; port < kPortCount; ++port) {
        if (!node.active[port] || node.kind == dc::DcKind::kNone) continue;
        ports.push_back(
            {{"port", port}, {"receive_time_ns", node.receive_time[port]}, {"after_entry_ns", away(port).value_or(0)}});
      }
      rows.push_back({{"position", i},
                      {"name", segment.name(i)},
                      {"clock", capability_text(survey.segment.capabilities[i])},
                      {"entry_port", entry},
                      {"ports", ports},
                      {"delay_ns", delay ? Json(*delay) : Json(nullptr)}});
      continue;
    }
    const auto text = [](auto value) { return value ? fmt::format("{}", *value) : std::string("-"); };
    context.console.out << fmt::format("{:>3} {:<24} {:<13} {:>5} {:>8} {:>8} {:>8} {:>9}\n", i, segment.name(i),
                                       capability_text(survey.segment.capabilities[i]), entry, text(away(3)),
                                       text(away(1)), text(away(2)), text(delay));
  }
  Json findings = Json::array();
  for (const auto& finding : survey.result.findings) {
    const auto told = delay_finding(finding.position, finding.warning, finding.value_ns);
    const auto words = facts_text(told);
    findings.push_back(to_json(told));
    findings.back()["position"] = finding.position;
    findings.back()["text"] = words;
    if (!json) context.console.err << fmt::format("warning: {}\n", words);
  }
  if (json) return context.print({{"rounds", survey.rounds}, {"slaves", rows}, {"findings", findings}});
  context.console.out << (survey.rounds == 0
                              ? "Times after the entry port in ns, of the last latch that anybody made.\n"
                              : fmt::format("Times after the entry port in ns, medians of {} latches.\n",
                                            survey.rounds));
}

void show_delays(Context& context, const DcOptions& options) {
  const InterruptGuard interrupt;
  auto segment = open_segment(options, interrupt);
  if (!segment) return context.fail_with(segment.error());
  const auto settings = segment->config ? segment->config->dc : DcMasterSettings{};
  const auto survey = survey_delays(segment->open->bus(), segment->addresses, options.look_only ? 0 : options.rounds,
                                    delay_options(settings));
  if (!survey) return context.fail_with(survey.error());
  print_delays(context, *segment, *survey, options.json);
}

void add_common(CLI::App& command, DcOptions& options) {
  command.add_option("link", options.link, "LINK")->required();
  auto* file = command.add_option("--project,--eni", options.file, "Project or ENI file: names, and what should be");
  command.add_option("--network", options.network, "Network of a project that holds several: name or number")
      ->needs(file);
  command.add_flag("--json", options.json, "Print JSON");
}

}  // namespace

void add_dc_command(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("dc", "Look at the distributed clocks of a bus");
  command->require_subcommand(1);
  auto status_options = std::make_shared<DcOptions>();
  auto* status = command->add_subcommand("status", "Show the clocks and SYNC units as they are; changes nothing");
  add_common(*status, *status_options);
  status->callback([&context, status_options] { show_status(context, *status_options); });

  auto delay_options = std::make_shared<DcOptions>();
  auto* delays = command->add_subcommand("delays", "Measure the propagation delays: ports, receive times, delays");
  add_common(*delays, *delay_options);
  auto* rounds = delays->add_option("--rounds", delay_options->rounds, "Latches whose medians count")
                     ->check(CLI::Range(1, 100))
                     ->capture_default_str();
  delays->add_flag("--look-only", delay_options->look_only, "Latch nothing: read the times that are there")
      ->excludes(rounds);
  delays->callback([&context, delay_options] { show_delays(context, *delay_options); });
}

}  // namespace syncline::cli
