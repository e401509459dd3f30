// SPDX-License-Identifier: Apache-2.0
#include "compile/mailbox_init_cmds.h"

#include <algorithm>

#include "compile/eoe_ip.h"
#include "compile/slave_plan.h"
#include "config/mailbox_config.h"
#include "config/mailbox_description.h"
#include "config/slave_options.h"
#include "config/slave_settings.h"
#include "config/startup_messages.h"
#include "config/startup_origin.h"
#include "protocol/eoe.h"

namespace syncline::compiler {
namespace {

bool sets_address(const MailboxInitCmd& message) {
  const auto header = eoe::decode(message.data);
  return header && header->kind == eoe::Kind::kSetIpRequest;
}

void add_eoe(MailboxConfig& mailbox, const SlavePlan& slave) {
  const EoeSlaveSettings& eoe = slave.settings->eoe;
  mailbox.eoe_disabled = !eoe.enabled;
  if (!eoe.enabled) return;
  const auto parameters = encode_ip_parameters(eoe, slave.settings->station_address);
  for (const MailboxInitCmd& message : slave.settings->eoe_startup) {
    // The user's address replaces the one that the ESI sets; a message of the user's own stays in any case.
    const bool replaced =
        !parameters.empty() && sets_address(message) && is_from_esi(message, slave.settings->device, MailboxType::kEoe);
    if (!replaced) mailbox.eoe_commands.push_back(message);
  }
  if (parameters.empty()) return;
  eoe::Header header;
  header.kind = eoe::Kind::kSetIpRequest;
  auto& message = mailbox.eoe_commands.emplace_back();
  message.transitions = {Transition::kIP};
  message.data = eoe::encode(header);
  message.data.insert(message.data.end(), parameters.begin(), parameters.end());
  message.comment = "set IP parameter";
}

/// ETG.2100 knows SoE commands on PS, SO, SP, OP and OS: what an ESI wants on the way to PREOP comes behind it, on PS,
/// since only there the mailbox is at work. On the ways to INIT there is no mailbox any more.
std::vector<Transition> soe_transitions(const std::vector<Transition>& wanted) {
  std::vector<Transition> out;
  for (const Transition transition : wanted) {
    const bool early = transition == Transition::kIP || transition == Transition::kPP || transition == Transition::kII;
    const Transition allowed = early ? Transition::kPS : transition;
    const bool known = allowed == Transition::kPS || allowed == Transition::kSO || allowed == Transition::kSP ||
                       allowed == Transition::kOP || allowed == Transition::kOS;
    if (known && std::ranges::find(out, allowed) == out.end()) out.push_back(allowed);
  }
  return out;
}

void add_soe(MailboxConfig& mailbox, const SlavePlan& slave) {
  for (const SoeCommand& command : slave.settings->soe_startup) {
    SoeInitCmd cmd;
    cmd.transitions = soe_transitions(command.transitions);
    if (cmd.transitions.empty()) continue;
    cmd.drive_no = command.drive;
    cmd.idn = command.idn;
    cmd.data = command.data;
    cmd.fixed = command.fixed;
    cmd.enabled = command.enabled;
    cmd.timeout_ms = command.timeout_ms;
    cmd.comment = command.comment;
    mailbox.soe_commands.push_back(std::move(cmd));
  }
}

}  // namespace

void add_mailbox_init_cmds(MailboxConfig& mailbox, const SlavePlan& slave) {
  if (mailbox.eoe) add_eoe(mailbox, slave);
  if (mailbox.soe) add_soe(mailbox, slave);
  mailbox.aoe_net_id = mailbox.aoe ? slave.settings->ams_net_id : std::string();
  for (const auto& protocol : kMessageProtocols) {
    const bool done = protocol.type == MailboxType::kEoe;
    if (mailbox.*protocol.spoken && !done) mailbox.*protocol.commands = slave.settings->*protocol.startup;
  }
}

}  // namespace syncline::compiler
