// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/mailbox_description.h"
#include "config/object_description.h"
#include "protocol/al_state.h"

/// The mailbox of a slave and what is sent through it at state transitions (ETG.2100, Mailbox).
namespace syncline {

struct CoeInitCmd {
  StartupCommand command;
  std::uint8_t ccs = 1;  // 1 = download, as all tools write it
  bool operator==(const CoeInitCmd&) const = default;
};

/// Start-up message of AoE, EoE, FoE or VoE: what follows the mailbox header, in wire order.
struct MailboxInitCmd {
  std::vector<Transition> transitions{};
  std::vector<std::uint8_t> data{};
  std::uint32_t timeout_ms = 0;  // 0 = the master's default
  bool enabled = true;
  bool fixed = false;
  std::string comment{};
  bool operator==(const MailboxInitCmd&) const = default;
};

/// Start-up write to an IDN of a SoE drive.
struct SoeInitCmd {
  std::vector<Transition> transitions{};
  std::uint8_t op_code = 3;  // write request
  std::uint8_t drive_no = 0;
  std::uint16_t idn = 0;
  std::uint8_t elements = 0x40;  // which elements of the IDN; 0x40 = its value
  std::uint8_t attribute = 0;
  std::vector<std::uint8_t> data{};
  std::uint32_t timeout_ms = 0;  // 0 = the master's default
  bool enabled = true;
  bool fixed = false;
  std::string comment{};
  bool operator==(const SoeInitCmd&) const = default;
};

struct MailboxChannel {
  std::uint16_t start = 0;
  std::uint16_t length = 0;
  bool short_send = false;  // ENI ShortSend: only the bytes of the message, not the whole buffer
  bool operator==(const MailboxChannel&) const = default;
};

/// ESI Info/Mailbox/Timeout; an ENI has no place for them, so that one that is read has the defaults.
struct MailboxTimeouts {
  std::uint32_t request_ms = 100;    // until the slave has taken a request out of its mailbox
  std::uint32_t response_ms = 2000;  // until its answer is there
  bool operator==(const MailboxTimeouts&) const = default;
};

struct MailboxConfig {
  MailboxChannel send, receive;  // send = master to slave (SM0)
  MailboxTimeouts timeouts;
  std::optional<std::uint32_t> poll_time_ms;
  std::optional<std::uint32_t> status_bit_address;
  std::optional<MailboxChannel> bootstrap_send, bootstrap_receive;
  bool data_link_layer = false;
  bool aoe = false, eoe = false, coe = false, foe = false, soe = false, voe = false;
  std::vector<CoeInitCmd> coe_commands;
  std::vector<ChannelProfile> profiles;
  std::vector<SoeInitCmd> soe_commands{};
  std::vector<MailboxInitCmd> aoe_commands{}, eoe_commands{}, foe_commands{}, voe_commands{};
  std::string aoe_net_id{};   // "1.2.3.4.5.6"; "" = none
  bool eoe_disabled = false;  // EoE@Disabled: the slave could, the configuration does not want it
  bool operator==(const MailboxConfig&) const = default;
};

}  // namespace syncline
