// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "config/project.h"
#include "config/slave_edits.h"
#include "support/expected.h"

namespace syncline::settings {
struct Setting;
}  // namespace syncline::settings

namespace syncline {

enum class Carry : std::uint8_t {
  kAll,      // every setting that the new one takes
  kChanged,  // those that the user changed; what the old device's default was is the new device's default
};

struct ReplacedSlave {
  SlaveSettings slave;
  std::vector<const settings::Setting*> lost;  // that the new device does not take; each once
};
/// `fresh` with the settings of `old` that it takes; not the place on the bus. Pure.
[[nodiscard]] ReplacedSlave replaced_slave(const SlaveSettings& old, const SlaveSettings& fresh, Carry carry);

struct ReplacedDevice {
  Project project;
  std::vector<std::string> lost;  // keys in `project`
};
/// The project with another device, or another revision of the same, in the place of a slave: place, names that the
/// user gave, addresses and the settings that it takes stay. kOtherKind where it cannot be plugged in there, kNoPort
/// where it lacks a port at which something hangs, kNoSuchSlave. Pure.
[[nodiscard]] Expected<ReplacedDevice, WiringObstacle> replace_device(const Project& project, std::size_t slave,
                                                                      const DeviceDescription& device);

}  // namespace syncline
