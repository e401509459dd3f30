// SPDX-License-Identifier: Apache-2.0
#include "compile/mailbox_init_cmds.h"

#include <algorithm>

#include "compile/eoe_ip.h"
#include "compile/slave_plan.h"
#include "config/mailbox_config.h"
#include "config/mailbox_description.h"
#include "config/slave_options.h"
#include "config/slave_settings.h"
#include "protocol/eoe.h"

namespace syncline::compiler {
namespace {

constexpr int kSetIpParameter = static_cast<int>(eoe::Kind::kSetIpRequest);

/// The header as tools write it (no fragment, no time stamp); then the service's data.
MailboxInitCmd eoe_message(int type, const std::vector<std::uint8_t>& data, std::vector<Transition> when,
                           std::string comment) {
  MailboxInitCmd message;
  message.transitions = std::move(when);
  message.comment = std::move(comment);
  eoe::Header header;
  header.kind = static_cast<eoe::Kind>(type & 0x0F);
  header.last_fragment = header.kind == eoe::Kind::kFragment;
  message.data = eoe::encode(header);
  message.data.insert(message.data.end(), data.begin(), data.end());
  return message;
}

void add_eoe(MailboxConfig& mailbox, const SlavePlan& slave) {
  const EoeSlaveSettings& eoe = slave.settings->eoe;
  mailbox.eoe_disabled = !eoe.enabled;
  if (!eoe.enabled) return;
  const auto parameters = encode_ip_parameters(eoe, slave.settings->station_address);
  for (const MailboxCommand& command : slave.device().mailbox->eoe_options.init_commands) {
    // The user's address replaces the one that the ESI sets.
    if (command.type == kSetIpParameter && !parameters.empty()) continue;
    mailbox.eoe_commands.push_back(eoe_message(command.type, command.data, command.transitions, command.comment));
  }
  if (!parameters.empty()) {
    mailbox.eoe_commands.push_back(eoe_message(kSetIpParameter, parameters, {Transition::kIP}, "set IP parameter"));
  }
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

void add_aoe(MailboxConfig& mailbox, const SlavePlan& slave) {
  mailbox.aoe_net_id = slave.settings->ams_net_id;
  for (const MailboxCommand& command : slave.device().mailbox->aoe_options.init_commands) {
    MailboxInitCmd cmd;
    cmd.transitions = command.transitions;
    cmd.data = command.data;
    cmd.comment = command.comment;
    mailbox.aoe_commands.push_back(std::move(cmd));
  }
}

}  // namespace

void add_mailbox_init_cmds(MailboxConfig& mailbox, const SlavePlan& slave) {
  if (mailbox.eoe) add_eoe(mailbox, slave);
  if (mailbox.soe) add_soe(mailbox, slave);
  if (mailbox.aoe) add_aoe(mailbox, slave);
}

}  // namespace syncline::compiler
