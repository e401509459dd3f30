// SPDX-License-Identifier: Apache-2.0
#include "app/cli/project_create.h"

#include <algorithm>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/difference_json.h"
#include "app/cli/findings_text.h"
#include "app/cli/identity_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/terminal_reason.h"
#include "app/composition/open_link.h"
#include "engine/describe_slaves.h"
#include "engine/opened_link.h"
#include "engine/scan_bus.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_builder.h"
#include "eni/project/project_file.h"
#include "eni/xml/file_warning.h"
#include "findings/error_text.h"
#include "recover/recover_project.h"
#include "settings/settings_keys.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

/// Findings and differences are for the user: they do not make the project useless.
Result<Project> recover(Context& context, const CreateOptions& options, const eni::EsiCatalogue& catalogue,
                        RecoveredProject& recovered) {
  auto imported = eni::import_eni(options.eni);
  if (!imported) return tl::unexpected(imported.error());
  recovered = recover_project(imported->config, [&catalogue](const Identity& identity) -> const DeviceDescription* {
    const auto match = catalogue.find(identity);
    return match && match->exact_revision ? match->device : nullptr;
  });
  recovered.findings.insert(recovered.findings.end(), imported->unread.begin(), imported->unread.end());
  if (!options.json) {
    print(context.console.err, recovered.findings);
    for (const auto& difference : recovered.differences) {
      context.console.err << "not as in the ENI: " << describe(difference) << '\n';
    }
  }
  return recovered.project;
}

void report(Context& context, const CreateOptions& options, std::size_t slaves, const RecoveredProject& recovered) {
  if (options.json) {
    Json json{{"file", options.file}, {"slaves", slaves}};
    if (!options.eni.empty()) {
      json["findings"] = to_json(recovered.findings);
      json["differences"] = differences_json(recovered.differences);
    }
    return context.print(json);
  }
  context.console.out << options.file << ": " << counted(slaves, "slave");
  if (!options.eni.empty()) {
    context.console.out << ", " << counted(recovered.differences.size(), "difference") << " to the commands of the ENI";
  }
  context.console.out << '\n';
}

Result<Project> build(Context& context, const CreateOptions& options, RecoveredProject& recovered) {
  auto catalogue = open_catalogue(context, options.esi);
  if (!catalogue) return tl::unexpected(catalogue.error());
  if (!options.eni.empty()) return recover(context, options, *catalogue, recovered);
  if (!options.scan.empty()) {
    const InterruptGuard interrupt;
    ScanRequest request;
    request.cancel = &interrupt.interrupted();
    const auto scan = scan_bus(open_link(options.scan), request);
    if (!scan) return tl::unexpected(scan.error());
    eni::SlaveDescriber describe;
    if (options.read_dictionaries) {
      describe = [&](Project& project) {
        return describe_slaves(
            project, [&] { return open_link(options.scan); }, request.cancel);
      };
    }
    auto built = eni::project_from_scan(*scan, *catalogue, describe);
    if (!built) return tl::unexpected(built.error());
    if (describe && interrupt.interrupted()) return fail(ErrorCode::kCancelled);
    for (const auto& warning : built->warnings) context.warn(warning);
    return std::move(built->project);
  }
  std::vector<Identity> devices;
  for (const auto& text : options.devices) {
    const auto identity = parse_identity(text);
    if (!identity) return tl::unexpected(identity.error());
    devices.push_back(*identity);
  }
  return eni::project_from_devices(devices, *catalogue);
}

/// The short options are only other spellings of settings keys.
Result<std::vector<SettingValue>> edits_of(const CreateOptions& options) {
  std::vector<SettingValue> edits;
  if (!options.cycle_us.empty()) edits.push_back({"master.cycle_time_us", options.cycle_us});
  if (!options.shift.empty()) {
    const bool is_short = options.shift == "bus" || options.shift == "master";
    edits.push_back({"master.dc.mode", is_short ? options.shift + "-shift" : options.shift});
  }
  if (!options.sync_window.empty()) edits.push_back({"master.dc.sync_window", options.sync_window});
  if (!options.reference_clock.empty()) edits.push_back({"master.dc.reference_clock", options.reference_clock});
  for (const auto& text : options.op_modes) {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
      return fail(ErrorCode::kBadValue, "--op-mode " + text, in_terminal("use POSITION=NAME"));
    edits.push_back({"slave." + text.substr(0, equals) + ".dc.op_mode", text.substr(equals + 1)});
  }
  return edits;
}

/// Puts a named network beside those that the file has; an unnamed one makes the file new.
Status save(const Project& project, const CreateOptions& options) {
  if (options.network.empty()) return eni::save_project(project, options.file);
  auto machine = eni::load_machine(options.file);
  if (!machine && machine.error().code != ErrorCode::kFileNotFound) return tl::unexpected(machine.error());
  if (!machine) machine = Machine{};
  const auto known = std::ranges::find(machine->networks, options.network, &Project::name);
  if (known != machine->networks.end()) {
    *known = project;
  } else {
    machine->networks.push_back(project);
  }
  return eni::save_machine(*machine, options.file);
}

}  // namespace

void create_project(Context& context, const CreateOptions& options) {
  CommandFiles files;
  files.reads_link("--scan", options.scan).reads("--eni", options.eni).writes("file", options.file);
  add_files(files, options.esi);
  if (const auto distinct = files.check(); !distinct) return context.fail_with(distinct.error());
  RecoveredProject recovered;
  auto project = build(context, options, recovered);
  if (!project) return context.fail_with(project.error());
  const auto edits = edits_of(options);
  if (!edits) return context.fail_with(edits.error());
  for (const auto& edit : *edits) {
    if (auto status = set_setting(*project, edit.key, edit.value); !status) return context.fail_with(status.error());
  }
  project->name = options.network;
  if (auto status = save(*project, options); !status) return context.fail_with(status.error());
  report(context, options, project->slaves.size(), recovered);
}

}  // namespace syncline::cli
