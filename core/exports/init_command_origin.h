// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::exports {

struct InitCommandRow;

/// What of a project an init command is there for, and so where it is changed.
enum class InitCommandOrigin : std::uint8_t {
  kStateMachine,   // AL control and status
  kAddresses,      // station address and alias
  kDeviceCheck,    // identity out of the EEPROM
  kSyncManagers,   // out of ESI and process data
  kFmmus,          // out of the process image
  kClocks,         // settings of distributed clocks
  kWatchdogs,      // watchdog settings
  kPorts,          // DL control, error counters
  kPdoAssignment,  // 0x1C10 to 0x1C2F
  kPdoMapping,     // 0x1600 to 0x17FF, 0x1A00 to 0x1BFF
  kEsi,            // start-up command that the ESI brings
  kStartup,        // of the project, on the page Start-up
  kOwn,            // register command of the user's own
  kSettings,       // follows from other settings of the slave
};

/// Pure. `row` is one of init_commands() of what `project` is compiled to.
[[nodiscard]] InitCommandOrigin origin_of(const InitCommandRow& row, const Project& project);

}  // namespace syncline::exports
