// SPDX-License-Identifier: Apache-2.0
#include "config/project.h"
#include "reasons/because.h"
#include "settings/predicates.h"
#include "settings/setting.h"
#include "settings/startup_text.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

Status set_command(SlaveSettings& slave, std::uint32_t number, std::string_view text) {
  const auto place = slave.startup.begin() + static_cast<std::ptrdiff_t>(number);
  if (text.empty()) {
    if (number < slave.startup.size()) slave.startup.erase(place);
    return {};
  }
  if (!slave.device.mailbox || !slave.device.mailbox->coe) return bad_value(because("the device has no CoE mailbox"));
  auto command = parse_startup(text);
  if (!command) return tl::unexpected(command.error());
  if (number < slave.startup.size()) {
    *place = std::move(*command);
  } else {
    slave.startup.push_back(std::move(*command));
  }
  return {};
}

}  // namespace

std::vector<Setting> startup_rows() {
  Setting row{
      .key = "slave.N.startup.K",
      .type = Record{"start-up command",
                     "TRANSITIONS INDEX:SUB=HEX [complete] [fixed] [off] [adapt] [timeout=MS] [# comment]; nothing "
                     "removes it"},
      .words = {.label = "Start-up command",
                .help =
                    "CoE object that is written at these transitions, K counts from 0; the number behind the last adds "
                    "one.",
                .eni = "Mailbox/CoE/InitCmds"},
      .read = {},
      .write = {}};
  row.read = [](const Project& project, const Place& place) -> Value {
    const auto& startup = project.slaves[place.slave].startup;
    return place.item < startup.size() ? format_startup(startup[place.item]) : std::string{};
  };
  row.write = [](Project& project, const Place& place, const Value& value) {
    return set_command(project.slaves[place.slave], place.item, std::get<std::string>(value));
  };
  row.items = [](const Project& project, std::size_t slave) {
    return numbered(slave, project.slaves[slave].startup.size());
  };
  row.extendable = true;
  row.applies = has_coe;
  return {row};
}

}  // namespace syncline::settings
