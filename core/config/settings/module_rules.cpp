// SPDX-License-Identifier: Apache-2.0
#include "config/module_slots.h"

#include <algorithm>

#include "config/compile/effective_slave.h"
#include "config/settings/codecs.h"
#include "config/settings/pdo_places.h"

namespace syncline::settings {
namespace {

constexpr std::string_view kNone = "none";
constexpr std::string_view kAuto = "auto";

Rule module_rule() {
  Rule rule{.key = "slave.N.module.K",
            .type = "module ident",
            .range = "none, ident of a module that fits place K",
            .meaning = "Module in place K of a modular device, counted from 0; its PDOs and start-up commands come with it.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) {
    const auto ident = plugged_module(project.slaves[place.slave], static_cast<std::uint16_t>(place.item));
    return ident ? fmt::format("0x{:08x}", *ident) : std::string(kNone);
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) -> Status {
    std::optional<std::uint32_t> ident;
    if (text != kNone) {
      const auto number = parse_integer(text);
      if (!number || *number < 0 || *number > 0xFFFF'FFFF) {
        return bad_value(fmt::format("\"{}\" is neither none nor a module ident", text));
      }
      ident = static_cast<std::uint32_t>(*number);
    }
    return plug_module(project.slaves[place.slave], static_cast<std::uint16_t>(place.item), ident);
  };
  rule.items = [](const Project& project, std::size_t slave) {
    return numbered(slave, slot_places(project.slaves[slave].device).size());
  };
  return rule;
}

/// Range that the ESI gives the factor; 1 where it says that there is none.
std::pair<std::uint16_t, std::uint16_t> factor_range(const Pdo& pdo) {
  constexpr std::uint16_t kLargest = 1000;
  const std::uint16_t min = std::max<std::uint16_t>(pdo.os_min.value_or(1), 1);
  return {min, std::max<std::uint16_t>(pdo.os_max.value_or(pdo.os_factor ? kLargest : 1), min)};
}

Status set_factor(SlaveSettings& slave, std::uint16_t index, std::string_view text) {
  auto& factors = slave.oversampling;
  const auto at = std::ranges::lower_bound(factors, index, {}, &PdoOversampling::pdo);
  const bool known = at != factors.end() && at->pdo == index;
  if (text == kAuto) {
    if (known) factors.erase(at);
    return {};
  }
  const auto factor = parse_integer(text);
  const auto pdo = pdo_of(slave, index);
  const auto [min, max] = pdo ? factor_range(*pdo) : std::pair<std::uint16_t, std::uint16_t>{1, 1};
  if (!factor || *factor < min || *factor > max) {
    return bad_value(fmt::format("\"{}\" is neither auto nor a factor from {} to {}", text, min, max));
  }
  if (known) {
    at->factor = static_cast<std::uint16_t>(*factor);
  } else {
    factors.insert(at, {index, static_cast<std::uint16_t>(*factor)});
  }
  return {};
}

Rule oversampling_rule() {
  Rule rule{.key = "slave.N.pdo.oversampling.0xIIII",
            .type = "integer",
            .range = "auto, OSMin..OSMax of the PDO in the ESI",
            .meaning = "How many samples of PDO 0xIIII a cycle carries; auto as the operation mode says.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) {
    const auto& factors = project.slaves[place.slave].oversampling;
    const auto found = std::ranges::find(factors, place.item, &PdoOversampling::pdo);
    return found == factors.end() ? std::string(kAuto) : std::to_string(found->factor);
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) {
    return set_factor(project.slaves[place.slave], static_cast<std::uint16_t>(place.item), text);
  };
  rule.items = [](const Project& project, std::size_t slave) {
    auto places = pdo_places(project.slaves[slave], slave);
    std::erase_if(places, [&](const Place& place) {
      const auto pdo = pdo_of(project.slaves[slave], place.item);
      return !pdo || !(pdo->os_factor || pdo->os_max);
    });
    return places;
  };
  return rule;
}

}  // namespace

std::vector<Rule> module_rules() { return {module_rule(), oversampling_rule()}; }

}  // namespace syncline::settings
