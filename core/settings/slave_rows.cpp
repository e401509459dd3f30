// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "reasons/because.h"
#include "settings/field.h"
#include "settings/limits.h"
#include "settings/number_text.h"
#include "settings/predicates.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

constexpr std::string_view kNone = "none";
constexpr std::int64_t kPorts = 4, kPortValues = 256;

/// Position and port as one number; a file may have a port that no slave has.
std::int64_t pack(const PreviousPort& previous) { return previous.position * kPortValues + previous.port; }

bool is_another(std::int64_t position, std::size_t own_position, std::size_t slaves) {
  return is_position(slaves, position) && !std::cmp_equal(position, own_position);
}

Reason no_other_slave(std::int64_t position, std::size_t slaves) {
  return because("slave {position} is not another slave of the {count} on the bus", position, slaves);
}

Result<Value> parse_previous(std::string_view text, std::size_t own_position, std::size_t slaves) {
  const auto colon = text.find(':');
  const auto position = parse_integer(text.substr(0, colon));
  const auto port = colon == std::string_view::npos ? std::string_view{"B"} : text.substr(colon + 1);
  if (!position || port.size() != 1 || port[0] < 'A' || port[0] > 'D') {
    return bad_value(because("\"{text}\" is neither none nor POSITION:PORT, like 0:B", text));
  }
  if (!is_another(*position, own_position, slaves)) return bad_value(no_other_slave(*position, slaves));
  return Value{pack({static_cast<std::uint16_t>(*position), static_cast<std::uint8_t>(port[0] - 'A')})};
}

Setting previous_row() {
  Setting row{
      .key = "slave.N.previous",
      .type = Record{"slave position and port", "POSITION:A..D of another slave", true},
      .words = {.label = "Connected to",
                .help = "Where the slave is plugged in towards the master. One behind it only when that one's cables "
                        "are swapped.",
                .object = "0x0110",
                .eni = "Slave/PreviousPort"},
      .read = {},
      .write = {}};
  row.unset = kNone;
  row.read = [](const Project& project, const Place& place) -> Value {
    const auto& previous = at_slave(project, place).previous;
    return previous ? Value{pack(*previous)} : Value{};
  };
  row.write = [](Project& project, const Place& place, const Value& value) -> Status {
    auto& previous = at_slave(project, place).previous;
    const auto* packed = std::get_if<std::int64_t>(&value);
    if (packed == nullptr) {
      previous.reset();
      return {};
    }
    const auto position = *packed / kPortValues;
    if (*packed < 0 || !is_another(position, place.slave, project.slaves.size())) {
      return bad_value(no_other_slave(position, project.slaves.size()));
    }
    const auto port = *packed % kPortValues;
    if (port >= kPorts) return bad_value(because("a slave has the ports A to D"));
    previous = {static_cast<std::uint16_t>(position), static_cast<std::uint8_t>(port)};
    return {};
  };
  row.parse = [](const Project& project, const Place& place, std::string_view text) {
    return parse_previous(text, place.slave, project.slaves.size());
  };
  row.format = [](const Project& project, const Place& place, const Value&) {
    const auto& previous = at_slave(project, place).previous;
    return previous ? fmt::format("{}:{:c}", previous->position, 'A' + previous->port) : std::string(kNone);
  };
  return row;
}

/// Name of a group, or none.
Setting hot_connect_row() {
  auto row = slave_setting(
      "hot_connect", Text{.form = "name of the group"},
      {.label = "Hot-connect group",
       .help = "This slave and those behind it may be absent and be plugged in anywhere, known by this "
               "slave's alias.",
       .object = "0x0012",
       .eni = "Slave/HotConnect"},
      [](auto& slave) -> auto& { return slave.hot_connect; });
  row.unset = kNone;
  row.read = [](const Project& project, const Place& place) -> Value {
    const auto& group = at_slave(project, place).hot_connect;
    return group.empty() ? Value{} : Value{group};
  };
  row.write = [](Project& project, const Place& place, const Value& value) -> Status {
    const auto* group = std::get_if<std::string>(&value);
    at_slave(project, place).hot_connect = group != nullptr ? *group : std::string();
    return {};
  };
  return row;
}

Setting check_row(const char* what, const char* label, const char* word, bool IdentityCheck::*part) {
  return slave_setting(
      fmt::format("check.{}", what), Switch{},
      {.label = label,
       .help = fmt::format("Compares the {} in the slave's EEPROM with the configured one at start-up.", what),
       .object = word,
       .eni = "InitCmd/Validate"},
      [part](auto& slave) -> auto& { return slave.check.*part; });
}

}  // namespace

std::vector<Setting> slave_rows() {
  return {
      slave_setting(
          "name", Text{},
          {.label = "Name",
           .help = "Name of the slave in the ENI file.",
           .eni = "Slave/Info/Name",
           .preset = "its device's"},
          [](auto& slave) -> auto& { return slave.name; }),
      slave_setting(
          "station_address", integer(1, limits::kLargestWord),
          {.label = "Station address",
           .help = "Address that the master gives the slave (0x0010).",
           .object = "0x0010",
           .eni = "Slave/Info/PhysAddr",
           .preset = "1001 + N"},
          [](auto& slave) -> auto& { return slave.station_address; }),
      slave_setting(
          "alias", integer(0, limits::kLargestWord),
          {.label = "Alias",
           .help = "Address in the slave's EEPROM (0x0012); 0 is none.",
           .object = "0x0012",
           .eni = "Slave/Info"},
          [](auto& slave) -> auto& { return slave.alias; }),
      previous_row(),
      hot_connect_row(),
      check_row("vendor", "Vendor", "SII 0x0008", &IdentityCheck::vendor),
      check_row("product", "Product code", "SII 0x000A", &IdentityCheck::product),
      check_row("revision", "Revision", "SII 0x000C", &IdentityCheck::revision),
      check_row("serial", "Serial number", "SII 0x000E", &IdentityCheck::serial),
  };
}

}  // namespace syncline::settings
