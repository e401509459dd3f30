// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "config/device_description.h"
#include "config/pdo_description.h"
#include "support/types.h"

namespace syncline {
struct SlaveConfig;
struct SlaveDcConfig;
}  // namespace syncline

namespace syncline::recover {

/// A description of the device as far as the ENI lets it be seen: identity, SyncManagers, FMMUs, PDOs, mailbox, one DC
/// operation mode named "DC" with the times that the ENI sets (a SYNC0 cycle that is the bus cycle as factor 1),
/// time-outs, watchdog registers. Not to be seen: what the device could do besides, its object dictionary, its other
/// operation modes.
[[nodiscard]] DeviceDescription recovered_device(const SlaveConfig& slave, Nanoseconds bus_cycle);

/// The device type that tools put into names: "Slave_1001 [type]", "Drive 1 (type)"; else from ProductRevision; else
/// the name.
[[nodiscard]] std::string device_type(const SlaveConfig& slave);

/// AssignActivate and times, from the element DC or else from the commands.
[[nodiscard]] std::optional<SlaveDcConfig> dc_of(const SlaveConfig& slave);

/// PDOs that the ENI assigns in this direction: as the SyncManagers list them, else those with an Sm attribute,
/// else what the start-up commands assign.
[[nodiscard]] std::vector<std::uint16_t> assigned_pdos(const SlaveConfig& slave, PdoDirection direction);

}  // namespace syncline::recover
