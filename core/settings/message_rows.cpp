// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "config/project.h"
#include "config/startup_messages.h"
#include "reasons/because.h"
#include "settings/field.h"
#include "settings/message_text.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

/// Item `number` of `list` becomes `text`; "" takes it out, the number behind the last adds one.
template <class Command>
Status set_item(std::vector<Command>& list, std::uint32_t number, std::string_view text,
                Result<Command> (*parse)(std::string_view)) {
  const auto place = list.begin() + static_cast<std::ptrdiff_t>(number);
  if (text.empty()) {
    if (number < list.size()) list.erase(place);
    return {};
  }
  auto command = parse(text);
  if (!command) return tl::unexpected(command.error());
  if (number < list.size()) {
    *place = std::move(*command);
  } else {
    list.push_back(std::move(*command));
  }
  return {};
}

/// A row for each item of `list(project, place)`.
template <class Command, class List>
Setting list_row(std::string key, const char* kind, const char* form, Words words, List list,
                 std::string (*format)(const Command&), Result<Command> (*parse)(std::string_view)) {
  Setting row{.key = std::move(key), .type = Record{kind, form}, .words = std::move(words), .read = {}, .write = {}};
  row.read = [list, format](const Project& project, const Place& place) -> Value {
    const std::vector<Command>& commands = list(project, place);
    return place.item < commands.size() ? format(commands[place.item]) : std::string{};
  };
  row.write = [list, parse](Project& project, const Place& place, const Value& value) {
    return set_item<Command>(list(project, place), place.item, std::get<std::string>(value), parse);
  };
  row.items = [list](const Project& project, std::size_t slave) {
    return numbered(slave, list(project, Place{slave, 0, 0}).size());
  };
  row.extendable = true;
  return row;
}

constexpr const char* kMessageForm = "TRANSITIONS data=HEX [fixed] [off] [timeout=MS] [# comment]; nothing removes it";
constexpr const char* kMasterForm =
    "TRANSITIONS write REGISTER=HEX or read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [after] [# "
    "comment]; nothing removes it";
constexpr const char* kSlaveForm =
    "TRANSITIONS write REGISTER=HEX or read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [# comment]; "
    "nothing removes it";

struct MessageWords {
  const char *label, *help, *eni;
  bool (*applies)(const SlaveSettings&);
};
template <std::size_t I>
bool speaks_it(const SlaveSettings& slave) {
  return speaks(slave.device, kMessageProtocols[I]);
}
/// In the order of kMessageProtocols.
constexpr MessageWords kMessageWords[] = {
    {"AoE start-up message",
     "AoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.",
     "Mailbox/AoE/InitCmds", speaks_it<0>},
    {"EoE start-up message",
     "EoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.",
     "Mailbox/EoE/InitCmds", speaks_it<1>},
    {"FoE start-up message",
     "FoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.",
     "Mailbox/FoE/InitCmds", speaks_it<2>},
    {"VoE start-up message",
     "VoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.",
     "Mailbox/VoE/InitCmds", speaks_it<3>}};

Setting message_row(std::size_t number) {
  const auto protocol = kMessageProtocols[number];
  const auto& words = kMessageWords[number];
  auto row = list_row<MailboxInitCmd>(
      fmt::format("slave.N.{}.startup.K", protocol.key), words.label, kMessageForm,
      {.label = words.label, .help = words.help, .eni = words.eni},
      [list = protocol.startup](auto& project, const Place& place) -> auto& {
        return project.slaves[place.slave].*list;
      },
      format_message, parse_message);
  row.applies = words.applies;
  row.write = [protocol, write = row.write](Project& project, const Place& place, const Value& value) -> Status {
    const bool removes = std::get<std::string>(value).empty();
    if (!removes && !speaks(project.slaves[place.slave].device, protocol)) {
      return bad_value(because("the device has no {protocol} mailbox", protocol.name));
    }
    return write(project, place, value);
  };
  return row;
}

}  // namespace

std::vector<Setting> message_rows() {
  std::vector<Setting> rows;
  for (std::size_t i = 0; i < kMessageProtocols.size(); ++i) rows.push_back(message_row(i));
  return rows;
}

std::vector<Setting> own_command_rows() {
  const auto slave = [](auto& project, const Place& place) -> auto& {
    return project.slaves[place.slave].register_commands;
  };
  const auto master = [](auto& project, const Place&) -> auto& { return project.master.register_commands; };
  auto of_slave = list_row<RegisterCommand>(
      "slave.N.register.K", "register command", kSlaveForm,
      {.label = "Register command",
       .help = "Register of the slave that is written or read at these transitions, K counts from 0; the number behind "
               "the last adds one.",
       .eni = "Slave/InitCmds",
       .expert = true},
      slave, format_register, parse_register);
  of_slave.write = [write = of_slave.write](Project& project, const Place& place, const Value& value) -> Status {
    const auto command = parse_register(std::get<std::string>(value));
    if (command && command->after_slaves) {
      return bad_value(because("only commands of the master stand behind those of the slaves"));
    }
    return write(project, place, value);
  };
  return {of_slave,
          list_row<RegisterCommand>(
              "master.register.K", "register command", kMasterForm,
              {.label = "Register command of the master",
               .help = "Register of all slaves that is written or read at these transitions, K counts from 0; "
                       "the number behind the last adds one.",
               .eni = "Master/InitCmds",
               .expert = true},
              master, format_register, parse_register)};
}

}  // namespace syncline::settings
