// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "config/dotted_address.h"
#include "protocol/frame.h"
#include "reasons/because.h"
#include "settings/field.h"
#include "settings/limits.h"
#include "settings/predicates.h"
#include "settings/startup_text.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

constexpr Text kIpAddress{.kind = "IPv4 address",
                          .form = "nothing, four numbers 0..255 with dots",
                          .may_be_empty = true,
                          .fits = [](std::string_view text) { return ipv4_bytes(text).has_value(); },
                          .example = "192.168.1.10"};
constexpr Text kNetId{.kind = "AMS Net ID",
                      .form = "nothing, six numbers 0..255 with dots",
                      .may_be_empty = true,
                      .fits = [](std::string_view text) { return ams_net_id_bytes(text).has_value(); },
                      .example = "5.1.2.3.1.1"};
constexpr Text kHostName{.kind = "host name", .most_bytes = limits::kHostNameBytes, .may_be_empty = true};

Setting size_row(const char* name, const char* label, const char* what, const char* sync_manager,
                 std::optional<std::uint16_t> MailboxSettings::*field) {
  constexpr std::int64_t kSmallest = 24, kLargest = kMaxDatagramData;
  return slave_setting(
      fmt::format("mailbox.{}_size", name), integer(kSmallest, kLargest, "bytes"),
      {.label = label,
       .help = fmt::format("Size of the {}; auto as in the ESI.", what),
       .object = sync_manager,
       .eni = "Slave/Mailbox",
       .expert = true},
      [field](auto& slave) -> auto& { return slave.mailbox.*field; });
}

std::vector<Setting> size_rows() {
  return {
      size_row("out", "Output mailbox", "output mailbox", "0x0802", &MailboxSettings::out_size),
      size_row("in", "Input mailbox", "input mailbox", "0x080A", &MailboxSettings::in_size),
      slave_setting(
          "mailbox.state_bit", Switch{},
          {.label = "Mailbox state by a bit",
           .help = "The master learns of mail by a bit in the cyclic frames, where the device has an FMMU for it; "
                   "off: it polls.",
           .object = "0x080D",
           .eni = "Slave/Mailbox/Recv/StatusBitAddr",
           .expert = true},
          [](auto& slave) -> auto& { return slave.mailbox.state_bit; }),
      slave_setting(
          "mailbox.poll_time_ms", integer(1, 60'000, "ms"),
          {.label = "Poll time",
           .help = "How often the mailbox is polled; auto as the dialect's tool.",
           .eni = "Slave/Mailbox/Recv/PollTime",
           .expert = true},
          [](auto& slave) -> auto& { return slave.mailbox.poll_time_ms; }),
  };
}

Setting address_row(const char* name, const char* what, std::string EoeSlaveSettings::*field) {
  return slave_setting(
      fmt::format("eoe.{}", name), kIpAddress,
      {.label = what,
       .help = fmt::format("{} that the slave gets at start-up (EoE).", what),
       .eni = "Mailbox/EoE/InitCmds"},
      [field](auto& slave) -> auto& { return slave.eoe.*field; });
}

std::vector<Setting> eoe_rows() {
  return {
      slave_setting(
          "eoe.enabled", Switch{},
          {.label = "Ethernet (EoE)",
           .help = "Ethernet frames are passed to and from the slave (EoE).",
           .eni = "Slave/Mailbox/EoE"},
          [](auto& slave) -> auto& { return slave.eoe.enabled; }),
      with_unset(slave_setting(
                     "eoe.mac", MacAddress{},
                     {.label = "Ethernet address",
                      .help = "Ethernet address that the slave gets at start-up (EoE).",
                      .eni = "Mailbox/EoE/InitCmds"},
                     [](auto& slave) -> auto& { return slave.eoe.mac; }),
                 "none"),
      address_row("ip", "IP address", &EoeSlaveSettings::ip),
      address_row("subnet", "Subnet mask", &EoeSlaveSettings::subnet),
      address_row("gateway", "Default gateway", &EoeSlaveSettings::gateway),
      address_row("dns", "Name server", &EoeSlaveSettings::dns),
      slave_setting(
          "eoe.host_name", kHostName,
          {.label = "Host name",
           .help = "Host name that the slave gets at start-up (EoE).",
           .eni = "Mailbox/EoE/InitCmds"},
          [](auto& slave) -> auto& { return slave.eoe.host_name; }),
  };
}

std::vector<Setting> aoe_rows() {
  return {slave_setting(
      "aoe.net_id", kNetId,
      {.label = "AMS Net ID", .help = "AMS Net ID of the slave (AoE).", .eni = "Slave/Mailbox/AoE/NetId"},
      [](auto& slave) -> auto& { return slave.ams_net_id; })};
}

Status set_soe(SlaveSettings& slave, std::uint32_t number, std::string_view text) {
  const auto place = slave.soe_startup.begin() + static_cast<std::ptrdiff_t>(number);
  if (text.empty()) {
    if (number < slave.soe_startup.size()) slave.soe_startup.erase(place);
    return {};
  }
  if (!slave.device.mailbox || !slave.device.mailbox->soe) return bad_value(because("the device has no SoE mailbox"));
  auto command = parse_soe(text);
  if (!command) return tl::unexpected(command.error());
  if (number < slave.soe_startup.size()) {
    *place = std::move(*command);
  } else {
    slave.soe_startup.push_back(std::move(*command));
  }
  return {};
}

Setting soe_row() {
  Setting row{
      .key = "slave.N.soe.K",
      .type = Record{"SoE start-up command",
                     "TRANSITIONS DRIVE:IDN=HEX [fixed] [off] [timeout=MS] [# comment]; IDN like S-0-0047; nothing "
                     "removes it"},
      .words = {.label = "SoE start-up command",
                .help =
                    "IDN that is written at these transitions, K counts from 0; the number behind the last adds one.",
                .eni = "Mailbox/SoE/InitCmds"},
      .read = {},
      .write = {}};
  row.read = [](const Project& project, const Place& place) -> Value {
    const auto& startup = at_slave(project, place).soe_startup;
    return place.item < startup.size() ? format_soe(startup[place.item]) : std::string{};
  };
  row.write = [](Project& project, const Place& place, const Value& value) {
    return set_soe(at_slave(project, place), place.item, std::get<std::string>(value));
  };
  row.items = [](const Project& project, std::size_t slave) {
    return numbered(slave, project.slaves[slave].soe_startup.size());
  };
  row.extendable = true;
  row.applies = has_soe;
  return row;
}

/// Name of a Sync Unit that the project has, or none.
Setting unit_row(const char* direction, const char* label, std::string SlaveSettings::*field) {
  auto row = slave_setting(
      fmt::format("sync_unit.{}", direction),
      Text{.form = "nothing, name of a master.sync_unit.K", .may_be_empty = true},
      {.label = label,
       .help = fmt::format("Sync Unit that exchanges the {}; nothing for the unnamed one in the base task.", direction),
       .eni = "Cyclic/Frame/Cmd"},
      [field](auto& slave) -> auto& { return slave.*field; });
  row.parse = [](const Project&, const Place&, std::string_view text) -> Result<Value> { return std::string(text); };
  row.write = [field](Project& project, const Place& place, const Value& value) -> Status {
    const auto& text = std::get<std::string>(value);
    const auto& units = project.master.sync_units;
    const bool known = text.empty() || text == at_slave(project, place).*field ||
                       std::ranges::find(units, text, &SyncUnit::name) != units.end();
    if (!known) {
      std::string names;
      for (const SyncUnit& unit : units) names += (names.empty() ? "" : ", ") + unit.name;
      return bad_value(
          because("there is no Sync Unit \"{name}\"; the project has {names}", text, names.empty() ? "none" : names));
    }
    at_slave(project, place).*field = text;
    return {};
  };
  return row;
}

}  // namespace

std::vector<Setting> mailbox_rows() {
  auto rows = for_devices(size_rows(), has_mailbox);
  append(rows, for_devices(eoe_rows(), has_eoe));
  append(rows, for_devices(aoe_rows(), has_aoe));
  rows.push_back(soe_row());
  append(rows, for_devices({unit_row("outputs", "Sync Unit of the outputs", &SlaveSettings::output_unit),
                            unit_row("inputs", "Sync Unit of the inputs", &SlaveSettings::input_unit)},
                           has_process_data));
  return rows;
}

}  // namespace syncline::settings
