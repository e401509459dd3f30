// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/terminal_reason.h"
#include "app/cli/visit_options.h"
#include "app/composition/open_link.h"
#include "engine/opened_link.h"
#include "master/mailbox/diagnosis_history_reader.h"
#include "master/startup/slave_visit.h"
#include "protocol/al_state.h"
#include "protocol/object_value.h"

namespace syncline::cli {
namespace {

struct SlavesOptions {
  SlaveOnLink slave;
  std::string state;
  bool json = false;
};

std::string_view type_text(DiagnosisMessage::Type type) {
  switch (type) {
    case DiagnosisMessage::Type::kInfo:
      return "info";
    case DiagnosisMessage::Type::kWarning:
      return "warning";
    case DiagnosisMessage::Type::kError:
      return "error";
  }
  return "unknown";
}

void print_history(Context& context, const SlavesOptions& options, const DiagnosisHistory& history) {
  if (options.json) {
    Json messages = Json::array();
    for (const auto& [sub_index, message] : history.messages) {
      Json parameters = Json::array();
      for (const auto& parameter : message.parameters) parameters.push_back(value_text(kBytesType, parameter.data));
      messages.push_back({{"sub_index", sub_index},
                          {"code", hex(message.code, 8)},
                          {"type", type_text(message.type)},
                          {"text_id", hex(message.text_id, 4)},
                          {"time_ns", message.time_stamp},
                          {"parameters", parameters}});
    }
    return context.print({{"position", options.slave.position},
                          {"new_available", history.new_available},
                          {"unreadable", history.unreadable},
                          {"messages", messages}});
  }
  auto& out = context.console.out;
  if (history.messages.empty())
    out << fmt::format("slave {}: its diagnosis history is empty\n", options.slave.position);
  for (const auto& [sub_index, message] : history.messages) {
    out << fmt::format("0x10F3:{:02X} {:<7} code 0x{:08X} text 0x{:04X} at {} ns", sub_index, type_text(message.type),
                       message.code, message.text_id, message.time_stamp);
    for (const auto& parameter : message.parameters)
      out << fmt::format(" [{}]", value_text(kBytesType, parameter.data));
    out << '\n';
  }
  if (history.unreadable > 0) out << fmt::format("{} messages cannot be read\n", history.unreadable);
}

void show_history(Context& context, const SlavesOptions& options) {
  with_mailbox(context, options.slave, [&](SlaveVisit& visit) -> Status {
    const auto history = read_diagnosis_history(visit.mailbox());
    if (!history) return tl::unexpected(history.error());
    print_history(context, options, *history);
    return {};
  });
}

void change_state(Context& context, const SlavesOptions& options) {
  const auto target = al_state_from_name(options.state);
  if (!target || *target == AlState::kNone) {
    return context.fail_with({ErrorCode::kBadValue, "STATE", in_terminal("one of INIT, PREOP, BOOT, SAFEOP, OP")});
  }
  const InterruptGuard interrupt;
  auto slave = options.slave;
  slave.cancel = &interrupt.interrupted();
  slave.on_left = [&context](const Error& error) { context.warn(error); };
  const auto work = [&](SlaveVisit& visit) -> Status {
    if (auto status = visit.lead_to(*target); !status) return status;
    if (options.json) {
      context.print(
          {{"position", slave.position}, {"from", al_state_name(visit.found())}, {"to", al_state_name(visit.state())}});
    } else {
      context.console.out << fmt::format("{}: {} to {}\n", visit.name(), al_state_name(visit.found()),
                                         al_state_name(visit.state()));
    }
    return {};
  };
  if (auto done = visit_slave(open_link(slave.link), slave, work, true); !done) context.fail_with(done.error());
}

}  // namespace

void add_slave_commands(CLI::App& app, Context& context) {
  auto reading = std::make_shared<SlavesOptions>();
  auto* history = app.add_subcommand("history", "Show the diagnosis history of a slave (0x10F3)");
  add_slave_options(*history, reading->slave, reading->json);
  history->callback([&context, reading] { show_history(context, *reading); });

  auto leading = std::make_shared<SlavesOptions>();
  auto* state = app.add_subcommand("state", "Lead a slave to a state and leave it there");
  add_slave_options(*state, leading->slave, leading->json);
  state->add_option("state", leading->state, "INIT, PREOP, BOOT, SAFEOP or OP")->required();
  state->callback([&context, leading] { change_state(context, *leading); });
}

}  // namespace syncline::cli
