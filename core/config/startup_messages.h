// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "config/device_description.h"
#include "config/mailbox_config.h"
#include "config/slave_settings.h"
#include "protocol/mailbox.h"

/// Start-up messages of the mailbox protocols that have no form of their own in an ENI (ETG.2100, Mailbox/AoE, EoE,
/// FoE, VoE).
namespace syncline {

struct MessageProtocol {
  MailboxType type;
  std::string_view name;                                // "AoE", as ESI and ENI write it
  std::string_view key;                                 // "aoe", in the keys of settings
  bool MailboxDescription::*known;                      // the device speaks it
  std::vector<MailboxInitCmd> SlaveSettings::*startup;  // what the project has
  bool MailboxConfig::*spoken;                          // the same in a configuration
  std::vector<MailboxInitCmd> MailboxConfig::*commands;
};
/// In the order in which an ENI has them.
inline constexpr std::array kMessageProtocols{
    MessageProtocol{MailboxType::kAoe, "AoE", "aoe", &MailboxDescription::aoe, &SlaveSettings::aoe_startup,
                    &MailboxConfig::aoe, &MailboxConfig::aoe_commands},
    MessageProtocol{MailboxType::kEoe, "EoE", "eoe", &MailboxDescription::eoe, &SlaveSettings::eoe_startup,
                    &MailboxConfig::eoe, &MailboxConfig::eoe_commands},
    MessageProtocol{MailboxType::kFoe, "FoE", "foe", &MailboxDescription::foe, &SlaveSettings::foe_startup,
                    &MailboxConfig::foe, &MailboxConfig::foe_commands},
    MessageProtocol{MailboxType::kVoe, "VoE", "voe", &MailboxDescription::voe, &SlaveSettings::voe_startup,
                    &MailboxConfig::voe, &MailboxConfig::voe_commands}};

/// What the ESI wants to be sent (ETG.2000: AoE and EoE InitCmd), as it stands behind the mailbox header: an ESI leaves
/// the header of EoE out. Nothing for FoE and VoE, which have no init commands in an ESI.
[[nodiscard]] std::vector<MailboxInitCmd> esi_messages(const DeviceDescription& device, MailboxType type);

/// The device speaks the protocol.
[[nodiscard]] bool speaks(const DeviceDescription& device, const MessageProtocol& protocol);

}  // namespace syncline
