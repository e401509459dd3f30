// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/cli/options.h"
#include "app/cli/project_advice.h"
#include "app/cli/project_create.h"
#include "app/cli/terminal_reason.h"
#include "app/composition/load_config.h"
#include "eni/project/project_file.h"
#include "settings/settings_keys.h"

namespace syncline::cli {
namespace {

struct FileOptions {
  std::string file;
  std::string network;                 // of a file with several
  std::vector<std::string> arguments;  // KEY=VALUE for set, KEY for show
  bool json = false;
};

Status apply(Project& project, const std::vector<std::string>& assignments) {
  for (const auto& argument : assignments) {
    const auto equals = argument.find('=');
    if (equals == std::string::npos) return fail(ErrorCode::kBadValue, argument, in_terminal("use KEY=VALUE"));
    const auto status = set_setting(project, std::string_view(argument).substr(0, equals),
                                    std::string_view(argument).substr(equals + 1));
    if (!status) return status;
  }
  return {};
}

void set(Context& context, const FileOptions& options) {
  auto machine = eni::load_machine(options.file);
  if (!machine) return context.fail_with(machine.error());
  const auto network = eni::find_network(*machine, options.network);
  if (!network) return context.fail_with(network.error());
  if (auto status = apply(machine->networks[*network], options.arguments); !status) {
    return context.fail_with(status.error());
  }
  if (auto status = eni::save_machine(*machine, options.file); !status) return context.fail_with(status.error());
}

Result<std::vector<SettingValue>> wanted_settings(const Project& project, const std::vector<std::string>& keys) {
  if (keys.empty()) return list_settings(project);
  std::vector<SettingValue> values;
  for (const auto& key : keys) {
    auto value = get_setting(project, key);
    if (!value) return tl::unexpected(value.error());
    values.push_back({key, std::move(*value)});
  }
  return values;
}

void show(Context& context, const FileOptions& options) {
  const auto project = load_any_project(options.file, options.network);
  if (!project) return context.fail_with(project.error());
  const auto values = wanted_settings(*project, options.arguments);
  if (!values) return context.fail_with(values.error());
  if (options.json) {
    Json settings = Json::object();
    for (const auto& setting : *values) settings[setting.key] = setting.value;
    return context.print({{"file", options.file}, {"settings", settings}});
  }
  for (const auto& setting : *values) context.console.out << setting.key << '=' << setting.value << '\n';
}

void keys(Context& context, bool json) {
  const auto descriptions = setting_descriptions();
  if (json) {
    Json rows = Json::array();
    for (const auto& d : descriptions) {
      rows.push_back({{"key", d.key},
                      {"type", d.type},
                      {"range", d.range},
                      {"meaning", d.meaning},
                      {"name", d.name},
                      {"default", d.preset},
                      {"goes_to", d.goes_to},
                      {"eni", d.eni},
                      {"no_eni", d.no_eni},
                      {"expert", d.expert}});
    }
    return context.print({{"keys", rows}});
  }
  for (const auto& d : descriptions) {
    context.console.out << fmt::format("{}\n    {}{}{}\n    {}\n", d.key, d.type, d.range.empty() ? "" : ", ", d.range,
                                       d.meaning);
  }
}

void add_create(CLI::App& project, Context& context) {
  auto* command = project.add_subcommand("create", "Create a project from a bus, from ESI files or from an ENI");
  auto options = std::make_shared<CreateOptions>();
  command->add_option("file", options->file, "Project file to write")->required();
  auto* scan = command->add_option("--scan", options->scan, "LINK of a bus to scan");
  auto* device = command->add_option("--device", options->devices, "VENDOR:PRODUCT[:REVISION], repeated in bus order");
  auto* eni = command->add_option("--eni", options->eni, "ENI file whose project is wanted, any tool's");
  scan->excludes(device)->excludes(eni);
  device->excludes(eni);
  add_esi_folders(*command, options->esi);
  command
      ->add_flag("!--no-dictionary", options->read_dictionaries,
                 "Leave slaves without an ESI in their state: configure them from their EEPROM alone")
      ->needs(scan);
  command->add_option("--cycle", options->cycle_us, "Cycle time in us");
  command->add_option("--shift", options->shift,
                      "bus, master, off, master-ref-clock, link-layer-ref-clock, dcx or master-shift-by-app");
  command->add_option("--sync-window", options->sync_window, "on or off")->check(CLI::IsMember({"on", "off"}));
  command->add_option("--reference-clock", options->reference_clock, "auto or a position");
  command->add_option("--op-mode", options->op_modes, "POSITION=NAME, repeatable");
  command->add_option("--network", options->network,
                      "Name of the network; joins or replaces it in a file that exists already");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] {
    if (options->scan.empty() && options->devices.empty() && options->eni.empty()) {
      return context.fail_with(Error{ErrorCode::kBadValue, "project create",
                                     in_terminal("give --scan LINK, --device VENDOR:PRODUCT or --eni FILE")});
    }
    create_project(context, *options);
  });
}

void add_file_command(CLI::App& project, Context& context, const char* name, const char* help, const char* what,
                      bool required, void (*action)(Context&, const FileOptions&)) {
  auto* command = project.add_subcommand(name, help);
  auto options = std::make_shared<FileOptions>();
  command->add_option("file", options->file, "Project file")->required();
  auto* arguments = command->add_option("settings", options->arguments, what);
  if (required) arguments->required();
  command->add_option("--network", options->network, "Network of a file that holds several: name or number");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options, action] { action(context, *options); });
}

}  // namespace

void add_project_commands(CLI::App& app, Context& context) {
  auto* project = app.add_subcommand("project", "Create, change and show project files");
  project->require_subcommand(1);
  add_create(*project, context);
  add_file_command(*project, context, "set", "Change settings", "KEY=VALUE", true, &set);
  add_file_command(*project, context, "show", "Show settings", "KEY (all when none is given)", false, &show);
  add_project_advice(*project, context);
  auto* command = project->add_subcommand("keys", "Explain every settings key");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print JSON");
  command->callback([&context, json] { keys(context, *json); });
}

}  // namespace syncline::cli
