// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "config/device_description.h"
#include "config/project.h"
#include "settings/settings_keys.h"
#include "tests/support/sample_devices.h"

/// A machine whose drive has every mailbox protocol, and messages of its ESI for two of them.
namespace syncline::sample {

inline DeviceDescription talkative_servo() {
  auto device = servo();
  device.mailbox->aoe = device.mailbox->eoe = device.mailbox->foe = device.mailbox->voe = true;
  device.mailbox->aoe_options.init_commands = {{{Transition::kPS}, 0, {1, 2, 3}, "from the ESI"}};
  device.mailbox->eoe_options.init_commands = {{{Transition::kIP}, 2, {0x02, 0, 0, 0, 10, 0, 0, 1}, "its address"}};
  return device;
}

inline Project talkative_machine() {
  auto machine = project({coupler()});
  machine.slaves.push_back(default_slave(talkative_servo(), 1));
  machine.slaves.back().previous = PreviousPort{0, 1};
  return machine;
}

inline void set_own(Project& project, const char* key, const char* value) {
  const auto status = set_setting(project, key, value);
  ASSERT_TRUE(status) << key << ": " << status.error().detail.text();
}

}  // namespace syncline::sample
