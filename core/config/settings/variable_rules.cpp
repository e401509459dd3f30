// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>

#include "config/settings/codecs.h"
#include "config/settings/pdo_places.h"

namespace syncline::settings {
namespace {

auto position(const VariableName& name) { return std::tuple(name.pdo, name.entry); }

std::tuple<std::uint16_t, std::uint16_t> position(const Place& place) {
  return {static_cast<std::uint16_t>(place.item), static_cast<std::uint16_t>(place.sub)};
}

Status set_name(SlaveSettings& slave, const Place& place, std::string_view text) {
  const auto name = TextCodec{}.parse(text);
  if (!name) return tl::unexpected(name.error());
  auto& names = slave.variable_names;
  const auto wanted = position(place);
  const auto at = std::ranges::lower_bound(names, wanted, {}, [](const VariableName& n) { return position(n); });
  const bool known = at != names.end() && position(*at) == wanted;
  if (name->empty()) {
    if (known) names.erase(at);
  } else if (known) {
    at->name = *name;
  } else {
    names.insert(at, {std::get<0>(wanted), std::get<1>(wanted), *name});
  }
  return {};
}

}  // namespace

std::vector<Rule> variable_rules() {
  const TextCodec codec;
  Rule rule{.key = "slave.N.variable.0xIIII.K",
            .type = codec.type(),
            .range = codec.range(),
            .meaning = "Name of the variable for entry K of PDO 0xIIII in the process image; nothing for SLAVE.PDO.ENTRY.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) -> std::string {
    for (const VariableName& name : project.slaves[place.slave].variable_names) {
      if (position(name) == position(place)) return name.name;
    }
    return {};
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) {
    return set_name(project.slaves[place.slave], place, text);
  };
  rule.items = [](const Project& project, std::size_t slave) { return entry_places(project.slaves[slave], slave); };
  return {rule};
}

}  // namespace syncline::settings
