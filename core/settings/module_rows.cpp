// SPDX-License-Identifier: Apache-2.0
#include "config/module_slots.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/dc_description.h"
#include "config/project.h"
#include "reasons/because.h"
#include "settings/limits.h"
#include "settings/number_text.h"
#include "settings/pdo_places.h"
#include "settings/setting.h"
#include "settings/setting_type.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

constexpr std::int64_t kLargestIdent = 0xFFFF'FFFF;

Result<Value> parse_ident(std::string_view text) {
  const auto number = parse_integer(text);
  if (number && *number >= 0 && *number <= kLargestIdent) return Value{*number};
  return bad_value(because("\"{text}\" is neither none nor a module ident", text));
}

Setting module_row() {
  Setting row{
      .key = "slave.N.module.K",
      .type = Number{.range = {0, kLargestIdent}, .hex_digits = 8},
      .words = {.label = "Module",
                .help = "Module in place K of a modular device, counted from 0; its PDOs and start-up commands come "
                        "with it.",
                .object = "0xF030",
                .eni = "Slave/ProcessData, Mailbox/CoE/InitCmds"},
      .read = {},
      .write = {}};
  row.unset = "none";
  row.type_words = "module ident";
  row.range_words = "none, ident of a module that fits place K";
  row.read = [](const Project& project, const Place& place) -> Value {
    const auto ident = plugged_module(project.slaves[place.slave], static_cast<std::uint16_t>(place.item));
    return ident ? Value{std::int64_t{*ident}} : Value{};
  };
  row.parse = [](const Project&, const Place&, std::string_view text) { return parse_ident(text); };
  row.write = [](Project& project, const Place& place, const Value& value) {
    const auto* number = std::get_if<std::int64_t>(&value);
    return plug_module(project.slaves[place.slave], static_cast<std::uint16_t>(place.item),
                       number != nullptr ? std::optional(static_cast<std::uint32_t>(*number)) : std::nullopt);
  };
  row.items = [](const Project& project, std::size_t slave) {
    return numbered(slave, slot_places(project.slaves[slave].device).size());
  };
  return row;
}

/// Range that the ESI gives the factor; 1 where it says that there is none.
Range factor_range(const Pdo& pdo) {
  const std::int64_t least = std::max<std::int64_t>(pdo.os_min.value_or(1), 1);
  const std::int64_t most = pdo.os_max ? *pdo.os_max : pdo.os_factor ? limits::kLargestMultiple : 1;
  return {least, std::max(most, least)};
}

Range factors_of(const SlaveSettings& slave, std::uint32_t index) {
  const auto pdo = pdo_of(slave, index);
  return pdo ? factor_range(*pdo) : Range{1, 1};
}

Status set_factor(SlaveSettings& slave, std::uint16_t index, const Value& value) {
  auto& factors = slave.oversampling;
  const auto found = std::ranges::lower_bound(factors, index, {}, &PdoOversampling::pdo);
  const bool known = found != factors.end() && found->pdo == index;
  const auto* factor = std::get_if<std::int64_t>(&value);
  if (factor == nullptr) {
    if (known) factors.erase(found);
    return {};
  }
  if (const auto range = factors_of(slave, index); !range.contains(*factor)) {
    return bad_value(
        because("\"{text}\" is neither auto nor a factor from {least} to {most}", *factor, range.low, range.high));
  }
  if (known) {
    found->factor = static_cast<std::uint16_t>(*factor);
  } else {
    factors.insert(found, {index, static_cast<std::uint16_t>(*factor)});
  }
  return {};
}

Setting oversampling_row() {
  Setting row{.key = "slave.N.pdo.oversampling.0xIIII",
              .type = integer(1, limits::kLargestWord),
              .words = {.label = "Oversampling",
                        .help = "How many samples of PDO 0xIIII a cycle carries; auto as the operation mode says.",
                        .eni = "Slave/ProcessData"},
              .read = {},
              .write = {}};
  row.unset = "auto";
  row.range_words = "auto, OSMin..OSMax of the PDO in the ESI";
  row.works = [](const Project& project, const Place& place) {
    return factors_of(project.slaves[place.slave], place.item);
  };
  row.read = [](const Project& project, const Place& place) -> Value {
    const auto& factors = project.slaves[place.slave].oversampling;
    const auto found = std::ranges::find(factors, place.item, &PdoOversampling::pdo);
    return found == factors.end() ? Value{} : Value{std::int64_t{found->factor}};
  };
  row.parse = [](const Project& project, const Place& place, std::string_view text) -> Result<Value> {
    if (const auto factor = parse_integer(text)) return Value{*factor};
    const auto range = factors_of(project.slaves[place.slave], place.item);
    return bad_value(
        because("\"{text}\" is neither auto nor a factor from {least} to {most}", text, range.low, range.high));
  };
  row.write = [](Project& project, const Place& place, const Value& value) {
    return set_factor(project.slaves[place.slave], static_cast<std::uint16_t>(place.item), value);
  };
  row.items = [](const Project& project, std::size_t slave) {
    auto places = pdo_places(project.slaves[slave], slave);
    std::erase_if(places, [&](const Place& place) {
      const auto pdo = pdo_of(project.slaves[slave], place.item);
      return !pdo || !(pdo->os_factor || pdo->os_max);
    });
    return places;
  };
  return row;
}

}  // namespace

std::vector<Setting> module_rows() { return {module_row(), oversampling_row()}; }

}  // namespace syncline::settings
