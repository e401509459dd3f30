// SPDX-License-Identifier: Apache-2.0
#include "config/startup_origin.h"

#include <algorithm>

#include "config/device_description.h"

namespace syncline {

bool is_from_esi(const StartupCommand& command, const DeviceDescription& device) {
  return device.mailbox && device.mailbox->coe &&
         std::ranges::find(device.mailbox->coe->init_commands, command) != device.mailbox->coe->init_commands.end();
}

}  // namespace syncline
