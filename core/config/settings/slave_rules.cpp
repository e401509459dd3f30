// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/settings/codecs.h"

namespace syncline::settings {
namespace {

constexpr Nanoseconds kRegisterMax = 0xFFFF'FFFF;  // 32 bit of nanoseconds: 0x09A0, 0x09A4
constexpr std::string_view kOff = "off";
constexpr std::string_view kNone = "none";

constexpr auto at = [](auto& project, const Place& place) -> auto& { return project.slaves[place.slave]; };

std::string mode_names(const SlaveSettings& slave) {
  std::string names(kOff);
  if (!slave.device.dc) return names + " (the device has no distributed clocks)";
  for (const DcOpMode& mode : slave.device.dc->op_modes) names += ", " + mode.name;
  return names;
}

Rule op_mode_rule() {
  Rule rule{.key = "slave.N.dc.op_mode",
            .type = "operation mode",
            .range = "off, a name of the ESI's OpMode",
            .meaning = "Operation mode of distributed clocks; where the ESI gives a mode its own PDOs, they are assigned too.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) {
    const auto& mode = at(project, place).dc.op_mode;
    return mode.empty() ? std::string(kOff) : mode;
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) -> Status {
    auto& slave = at(project, place);
    if (text == slave.dc.op_mode) return {};
    const bool known = slave.device.dc && std::ranges::any_of(slave.device.dc->op_modes,
                                                              [text](const DcOpMode& m) { return m.name == text; });
    if (!known && text != kOff) return bad_value(fmt::format("\"{}\" is none of {}", text, mode_names(slave)));
    select_op_mode(slave, known ? text : std::string_view{});
    return {};
  };
  return rule;
}

Result<std::optional<PreviousPort>> parse_previous(std::string_view text, std::size_t own_position, std::size_t slaves) {
  if (text == kNone) return std::optional<PreviousPort>{};
  const auto colon = text.find(':');
  const auto position = parse_integer(text.substr(0, colon));
  const auto port = colon == std::string_view::npos ? std::string_view{"B"} : text.substr(colon + 1);
  if (!position || port.size() != 1 || port[0] < 'A' || port[0] > 'D') {
    return bad_value(fmt::format("\"{}\" is neither none nor POSITION:PORT, like 0:B", text));
  }
  const auto other = static_cast<std::uint64_t>(*position);
  if (*position < 0 || other >= slaves || other == own_position) {
    return bad_value(fmt::format("slave {} is not another slave of the {} on the bus", *position, slaves));
  }
  return std::optional(PreviousPort{static_cast<std::uint16_t>(*position), static_cast<std::uint8_t>(port[0] - 'A')});
}

Rule previous_rule() {
  Rule rule{.key = "slave.N.previous",
            .type = "slave position and port",
            .range = "none, POSITION:A..D of another slave",
            .meaning = "Where the slave is plugged in towards the master. One behind it only when that one's cables are swapped.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) {
    const auto& previous = at(project, place).previous;
    return previous ? fmt::format("{}:{:c}", previous->position, 'A' + previous->port) : std::string(kNone);
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) -> Status {
    const auto previous = parse_previous(text, place.slave, project.slaves.size());
    if (!previous) return tl::unexpected(previous.error());
    at(project, place).previous = *previous;
    return {};
  };
  return rule;
}

/// Name of a group, or none.
Rule hot_connect_rule() {
  Rule rule{.key = "slave.N.hot_connect",
            .type = "name",
            .range = "none, name of the group",
            .meaning = "This slave and those behind it may be absent and be plugged in anywhere, known by this slave's alias.",
            .get = {},
            .set = {}};
  rule.get = [](const Project& project, const Place& place) {
    const auto& group = at(project, place).hot_connect;
    return group.empty() ? std::string(kNone) : group;
  };
  rule.set = [](Project& project, const Place& place, std::string_view text) -> Status {
    if (text == kNone) {
      at(project, place).hot_connect.clear();
      return {};
    }
    const auto name = NameCodec{}.parse(text);
    if (!name) return tl::unexpected(name.error());
    at(project, place).hot_connect = *name;
    return {};
  };
  return rule;
}

struct FactorCodec : IntegerCodec<int> {
  FactorCodec() : IntegerCodec<int>{-1000, 1000} {}
  [[nodiscard]] static std::string range() { return "-1000..-1, 1..1000"; }
  [[nodiscard]] Result<int> parse(std::string_view text) const {
    if (parse_integer(text) == 0) return bad_value("the factor 0 gives no cycle; switch the operation mode off instead");
    return IntegerCodec<int>::parse(text);
  }
};

std::vector<Rule> sync_unit_rules(const std::string& name, const std::string& register_text,
                                  SyncUnitSettings DcSlaveSettings::*unit) {
  const auto field = [unit](auto& project, const Place& place) -> auto& { return at(project, place).dc.*unit; };
  const std::string key = "slave.N.dc." + name, upper = name == "sync0" ? "SYNC0" : "SYNC1";
  return {
      field_rule(key + ".factor",
                 "Sync Unit Cycle of " + upper + ": above 0 multiplies, below 0 divides the bus cycle; auto as in the ESI.",
                 AutoCodec<FactorCodec>{}, [field](auto& p, const Place& place) -> auto& { return field(p, place).cycle_factor; }),
      field_rule(key + ".cycle_us", "Cycle of " + upper + " (" + register_text + "), before the factor.",
                 AutoCodec<MicrosecondCodec>{{1, kRegisterMax}},
                 [field](auto& p, const Place& place) -> auto& { return field(p, place).user_cycle; }),
      field_rule(key + ".shift_us", "Shift of " + upper + "; auto as in the ESI.",
                 AutoCodec<MicrosecondCodec>{{-kRegisterMax, kRegisterMax}},
                 [field](auto& p, const Place& place) -> auto& { return field(p, place).shift; }),
  };
}

std::vector<Rule> identity_rules() {
  const auto check = [](const char* what, bool IdentityCheck::*part) {
    return field_rule(fmt::format("slave.N.check.{}", what),
                      fmt::format("Compares the {} in the slave's EEPROM with the configured one at start-up.", what),
                      SwitchCodec{}, [part](auto& p, const Place& place) -> auto& { return at(p, place).check.*part; });
  };
  return {
      field_rule("slave.N.name", "Name of the slave in the ENI file.", NameCodec{},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).name; }),
      field_rule("slave.N.station_address", "Address that the master gives the slave (0x0010).",
                 IntegerCodec<std::uint16_t>{1, 65'535},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).station_address; }),
      field_rule("slave.N.alias", "Address in the slave's EEPROM (0x0012); 0 is none.", IntegerCodec<std::uint16_t>{0, 65'535},
                 [](auto& p, const Place& place) -> auto& { return at(p, place).alias; }),
      previous_rule(),
      hot_connect_rule(),
      check("vendor", &IdentityCheck::vendor),
      check("product", &IdentityCheck::product),
      check("revision", &IdentityCheck::revision),
      check("serial", &IdentityCheck::serial),
  };
}

}  // namespace

std::vector<Rule> slave_rules() {
  auto rules = identity_rules();
  rules.push_back(op_mode_rule());
  for (auto more : {sync_unit_rules("sync0", "0x09A0", &DcSlaveSettings::sync0),
                    sync_unit_rules("sync1", "0x09A4", &DcSlaveSettings::sync1)}) {
    rules.insert(rules.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  rules.push_back(field_rule("slave.N.dc.potential_reference_clock", "Marks the slave as a possible reference clock in the ENI.",
                             SwitchCodec{},
                             [](auto& p, const Place& place) -> auto& { return at(p, place).dc.potential_reference_clock; }));
  return rules;
}

}  // namespace syncline::settings
