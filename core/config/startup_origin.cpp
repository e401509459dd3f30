// SPDX-License-Identifier: Apache-2.0
#include "config/startup_origin.h"

#include <algorithm>

#include "config/device_description.h"
#include "config/startup_messages.h"

namespace syncline {

bool is_from_esi(const StartupCommand& command, const DeviceDescription& device) {
  return device.mailbox && device.mailbox->coe &&
         std::ranges::find(device.mailbox->coe->init_commands, command) != device.mailbox->coe->init_commands.end();
}

bool is_from_esi(const SoeCommand& command, const DeviceDescription& device) {
  return device.mailbox && device.mailbox->soe &&
         std::ranges::find(device.mailbox->soe_options.init_commands, command) !=
             device.mailbox->soe_options.init_commands.end();
}

bool is_from_esi(const MailboxInitCmd& message, const DeviceDescription& device, MailboxType type) {
  const auto messages = esi_messages(device, type);
  return std::ranges::find(messages, message) != messages.end();
}

}  // namespace syncline
