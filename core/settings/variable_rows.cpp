// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>

#include "config/project.h"
#include "settings/pdo_places.h"
#include "settings/setting.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

auto position(const VariableName& name) { return std::tuple(name.pdo, name.entry); }

std::tuple<std::uint16_t, std::uint16_t> position(const Place& place) {
  return {static_cast<std::uint16_t>(place.item), static_cast<std::uint16_t>(place.sub)};
}

void set_name(SlaveSettings& slave, const Place& place, const std::string& name) {
  auto& names = slave.variable_names;
  const auto wanted = position(place);
  const auto found = std::ranges::lower_bound(names, wanted, {}, [](const VariableName& n) { return position(n); });
  const bool known = found != names.end() && position(*found) == wanted;
  if (name.empty()) {
    if (known) names.erase(found);
  } else if (known) {
    found->name = name;
  } else {
    names.insert(found, {std::get<0>(wanted), std::get<1>(wanted), name});
  }
}

}  // namespace

std::vector<Setting> variable_rows() {
  Setting row{.key = "slave.N.variable.0xIIII.K",
              .type = Text{.kind = "text", .may_be_empty = true},
              .words = {.label = "Variable",
                        .help = "Name of the variable for entry K of PDO 0xIIII in the process image; nothing for "
                                "SLAVE.PDO.ENTRY.",
                        .eni = "ProcessImage/Variable/Name"},
              .read = {},
              .write = {}};
  row.read = [](const Project& project, const Place& place) -> Value {
    for (const VariableName& name : project.slaves[place.slave].variable_names) {
      if (position(name) == position(place)) return name.name;
    }
    return std::string();
  };
  row.write = [](Project& project, const Place& place, const Value& value) -> Status {
    set_name(project.slaves[place.slave], place, std::get<std::string>(value));
    return {};
  };
  row.items = [](const Project& project, std::size_t slave) { return entry_places(project.slaves[slave], slave); };
  return {row};
}

}  // namespace syncline::settings
