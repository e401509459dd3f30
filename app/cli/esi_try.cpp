// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/context.h"
#include "app/cli/esi_command.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "engine/try_esi.h"
#include "eni/trial/eni_trial_files.h"
#include "findings/error_text.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

struct TryOptions {
  std::string path, keep;
  unsigned threads = 0, every = 1;
  bool json = false, all = false;
};

Json device_json(const TriedDevice& device) {
  Json json{{"file", device.file}};
  if (device.line != 0) json["line"] = device.line;
  json["identity"] = to_string(device.identity);
  json["type"] = device.type;
  json["name"] = device.name;
  json["outcome"] = outcome_name(device.outcome);
  json["step"] = step_name(device.step);
  if (!device.reason.empty()) json["reason"] = device.reason;
  json["modules"] = device.modules;
  json["wkc_expected"] = device.wkc_expected;
  json["cycles"] = device.cycles;
  return json;
}

Json report_json(const TryReport& report) {
  Json json{{"files", report.files},
            {"tried", report.devices.size()},
            {"passed", report.count(TryOutcome::kPassed)},
            {"excepted", report.count(TryOutcome::kExcepted)},
            {"failed", report.count(TryOutcome::kFailed)},
            {"cancelled", report.cancelled},
            {"unreadable", Json::array()},
            {"devices", Json::array()}};
  for (const Error& error : report.unreadable) json["unreadable"].push_back(describe(error));
  for (const TriedDevice& device : report.devices) json["devices"].push_back(device_json(device));
  return json;
}

void print_device(std::ostream& out, const TriedDevice& device) {
  out << outcome_name(device.outcome) << "  " << device.file
      << (device.line != 0 ? ":" + std::to_string(device.line) : "");
  if (!device.type.empty()) out << "  " << device.type << "  " << to_string(device.identity);
  if (device.outcome != TryOutcome::kPassed) out << "\n    " << step_name(device.step) << ": " << device.reason;
  out << '\n';
}

void try_devices(Context& context, const TryOptions& options) {
  const InterruptGuard interrupt;
  TryRequest request{.path = options.path,
                     .threads = options.threads,
                     .every = options.every,
                     .keep = options.keep,
                     .stop = &interrupt.interrupted()};
  if (!options.json) {
    request.on_device = [&](const TriedDevice& device) {
      if (options.all || device.outcome != TryOutcome::kPassed) print_device(context.console.out, device);
    };
  }
  const auto report = try_esi(request, eni::trial_files());
  if (!report) return context.fail_with(report.error());
  if (report->count(TryOutcome::kFailed) > 0 || !report->unreadable.empty() || report->cancelled)
    context.exit_code = kAnswerIsNo;
  if (options.json) return context.print(report_json(*report));
  for (const Error& error : report->unreadable) context.warn(error);
  context.console.out << counted(report->files, "file") << ", " << counted(report->devices.size(), "device")
                      << " tried: " << report->count(TryOutcome::kPassed) << " passed, "
                      << report->count(TryOutcome::kExcepted) << " excepted, " << report->count(TryOutcome::kFailed)
                      << " failed" << (report->cancelled ? "; cancelled before all were tried" : "") << '\n';
}

}  // namespace

void add_esi_try(CLI::App& esi, Context& context) {
  auto* command = esi.add_subcommand(
      "try", "Bring every device of ESI files into OP, each in a project of its own on a simulated bus");
  auto options = std::make_shared<TryOptions>();
  command->add_option("path", options->path, "ESI file, or folder of ESI files")->required();
  command->add_option("--threads", options->threads, "Devices tried at the same time; 0: one for each processor");
  command->add_option("--every", options->every, "Try only each n-th device of a file")->check(CLI::Range(1, 100000));
  command->add_option("--keep", options->keep, "Folder to keep the ENI file of each device in")
      ->check(CLI::ExistingDirectory);
  command->add_flag("--all", options->all, "List the devices that passed too");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { try_devices(context, *options); });
}

}  // namespace syncline::cli
