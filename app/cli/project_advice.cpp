// SPDX-License-Identifier: Apache-2.0
#include "app/cli/project_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "advice/cycle_time_help.h"
#include "advice/image_report.h"
#include "app/cli/context.h"
#include "app/cli/options.h"
#include "app/composition/load_config.h"
#include "compile/compile.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

constexpr std::size_t kRows = 20;  // of lists in the text form; JSON has all

struct ProjectAdviceOptions {
  std::string file, network;
  bool json = false;
};

double us(Nanoseconds time) { return static_cast<double>(time) / 1e3; }

Json candidate_json(const CycleCandidate& candidate) {
  Json refusals = Json::array();
  for (const auto& refusal : candidate.refusals) {
    refusals.push_back({{"slave", refusal.slave},
                        {"name", refusal.name},
                        {"reason", refusal.reason.text()},
                        {"partly", refusal.partly}});
  }
  return {{"cycle_us", us(candidate.cycle)}, {"accepted", candidate.accepted()}, {"refusals", refusals}};
}

Json optional_us(const std::optional<Nanoseconds>& time) { return time ? Json(us(*time)) : Json(nullptr); }

void print_json(Context& context, const ProjectAdviceOptions& options, const CycleTimeHelp& help) {
  Json candidates = Json::array();
  for (const auto& candidate : help.candidates) candidates.push_back(candidate_json(candidate));
  context.print({{"file", options.file},
                 {"step_us", us(help.step)},
                 {"shortest_us", optional_us(help.shortest)},
                 {"longest_us", optional_us(help.longest)},
                 {"current", candidate_json(help.current)},
                 {"candidates", candidates}});
}

const char* verdict(const CycleCandidate& candidate) {
  if (!candidate.accepted()) return "refused";
  return candidate.refusals.empty() ? "all slaves accept it" : "accepted, with losses";
}

void print_text(Context& context, const CycleTimeHelp& help) {
  auto& out = context.console.out;
  for (const auto& candidate : help.candidates) {
    const bool own = candidate.cycle == help.current.cycle;
    out << fmt::format("{:>9g} us  {}{}\n", us(candidate.cycle), verdict(candidate),
                       own ? " (the project's cycle)" : "");
    for (std::size_t i = 0; i < candidate.refusals.size(); ++i) {
      if (i == 3) {
        out << fmt::format("              and {} more\n", candidate.refusals.size() - i);
        break;
      }
      const auto& refusal = candidate.refusals[i];
      const std::string who = refusal.slave < 0 ? "bus" : fmt::format("slave {} {}", refusal.slave, refusal.name);
      out << fmt::format("              {}: {}\n", who, refusal.reason.text());
    }
  }
}

void cycle_times(Context& context, const ProjectAdviceOptions& options) {
  const auto project = load_any_project(options.file, options.network);
  if (!project) return context.fail_with(project.error());
  const auto help = cycle_time_help(*project);
  if (!help) return context.fail_with(help.error());
  if (!help->current.accepted()) context.exit_code = kAnswerIsNo;
  options.json ? print_json(context, options, *help) : print_text(context, *help);
}

void print_json(Context& context, const ProjectAdviceOptions& options, const ImageReport& report) {
  Json frames = Json::array(), slaves = Json::array(), movable = Json::array();
  for (const auto& frame : report.frames) {
    frames.push_back({{"task", frame.task},
                      {"cycle_us", us(frame.cycle)},
                      {"datagrams", frame.datagrams},
                      {"bytes", frame.bytes},
                      {"process_data_bytes", frame.process_data_bytes},
                      {"wire_time_us", us(frame.wire_time)}});
  }
  for (const auto& slave : report.slaves) {
    slaves.push_back({{"slave", slave.slave},
                      {"name", slave.name},
                      {"output_bytes", slave.output_bytes},
                      {"input_bytes", slave.input_bytes},
                      {"bytes", slave.bytes},
                      {"wire_time_us", us(slave.wire_time)}});
  }
  for (const auto& object : report.movable) {
    movable.push_back({{"slave", object.slave},
                       {"name", object.name},
                       {"pdo", hex(object.pdo, 4)},
                       {"index", hex(object.index, 4)},
                       {"sub_index", object.sub_index},
                       {"object", object.object},
                       {"bits", object.bits},
                       {"saved_bytes", object.saved_bytes},
                       {"saved_wire_time_us", us(object.saved_wire_time)}});
  }
  context.print({{"file", options.file},
                 {"cycle_us", us(report.cycle)},
                 {"output_bytes", report.output_bytes},
                 {"input_bytes", report.input_bytes},
                 {"frames_per_cycle", report.frames_per_cycle},
                 {"wire_time_us", us(report.wire_time)},
                 {"busiest_wire_time_us", us(report.busiest_wire_time)},
                 {"bandwidth", report.bandwidth},
                 {"frames", frames},
                 {"slaves", slaves},
                 {"movable", movable},
                 {"travel_time_us", us(report.travel_time)},
                 {"busiest_cycle_us", us(report.busiest_cycle)}});
}

void print_text(Context& context, const ImageReport& report) {
  auto& out = context.console.out;
  const bool one = report.frames_per_cycle == 1;
  out << fmt::format("{} out, {} in; {:g} {} a cycle of {:g} us {} {:g} us of wire time: {:.1f} % of the bandwidth\n",
                     counted(report.output_bytes, "byte"), counted(report.input_bytes, "byte"), report.frames_per_cycle,
                     one ? "frame" : "frames", us(report.cycle), one ? "takes" : "take", us(report.wire_time),
                     report.bandwidth * 100);
  out << fmt::format("on its way through {} a frame needs about {:g} us: the last one is back after {:g} us{}\n",
                     counted(report.slaves.size(), "slave"), us(report.travel_time), us(report.busiest_cycle),
                     report.busiest_cycle > report.cycle ? ", which is longer than the cycle" : "");
  for (std::size_t i = 0; i < report.frames.size(); ++i) {
    const auto& frame = report.frames[i];
    out << fmt::format("frame {}: every {:g} us, {}, {} ({} of process data), {:g} us\n", i, us(frame.cycle),
                       counted(frame.datagrams, "datagram"), counted(frame.bytes, "byte"), frame.process_data_bytes,
                       us(frame.wire_time));
  }
  out << "costliest slaves:\n";
  for (std::size_t i = 0; i < std::min(kRows, report.slaves.size()); ++i) {
    const auto& slave = report.slaves[i];
    out << fmt::format("  {:>3} {}: {} out, {} in, {:g} us a cycle\n", slave.slave, slave.name, slave.output_bytes,
                       slave.input_bytes, us(slave.wire_time));
  }
  std::size_t row = 0;  // the most worth while first; what saves nothing by itself is in the JSON only
  for (const auto& object : report.movable) {
    if (object.saved_bytes == 0 || row == kRows) break;
    if (row++ == 0) out << "objects that could be exchanged by SDO:\n";
    out << fmt::format("  {:>3} {}: 0x{:04x}:{:02x} {} in PDO 0x{:04x}, {} bits, saves {}, {:g} us\n", object.slave,
                       object.name, object.index, object.sub_index, object.object, object.pdo, object.bits,
                       counted(object.saved_bytes, "byte"), us(object.saved_wire_time));
  }
}

void report(Context& context, const ProjectAdviceOptions& options) {
  const auto project = load_any_project(options.file, options.network);
  if (!project) return context.fail_with(project.error());
  const auto compiled = compile(*project);
  if (!compiled) return context.fail_with(compiled.error());
  const auto result = image_report(*project, compiled->config);
  options.json ? print_json(context, options, result) : print_text(context, result);
}

void add(CLI::App& project, Context& context, const char* name, const char* help,
         void (*action)(Context&, const ProjectAdviceOptions&)) {
  auto* command = project.add_subcommand(name, help);
  auto options = std::make_shared<ProjectAdviceOptions>();
  command->add_option("file", options->file, "Project or ENI file")->required();
  command->add_option("--network", options->network, "Network of a file that holds several: name or number");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options, action] { action(context, *options); });
}

}  // namespace

void add_project_advice(CLI::App& project, Context& context) {
  add(project, context, "cycle-times", "Cycle times that all slaves accept, and who refuses the others", &cycle_times);
  add(project, context, "report", "Bytes and wire time of the frames, who makes them, what could move to SDO", &report);
}

}  // namespace syncline::cli
