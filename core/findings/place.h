// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>

namespace syncline {

/// Which kind of thing of a NetworkConfig is meant; says how many of the indexes of a ConfigPlace count.
enum class PlaceKind : std::uint8_t {
  kConfig,  // all of it
  kMaster,
  kMasterInitCmd,  // command
  kSlave,          // slave
  kSlaveInitCmd,   // slave, command
  kSyncManager,    // slave, index in sync_managers
  kPdo,            // slave, index in pdos
  kMailbox,        // slave
  kCoeCmd,         // slave, command
  kHotConnect,     // slave
  kDc,             // slave
  kTask,           // task
  kFrame,          // task, frame
  kCyclicCmd,      // task, frame, command
  kImage,
  kInput,   // variable
  kOutput,  // variable
};

/// Names a thing of a NetworkConfig, so that a reader that knows lines can say where it stands.
struct ConfigPlace {
  PlaceKind kind = PlaceKind::kConfig;
  std::size_t first = 0, second = 0, third = 0;
  auto operator<=>(const ConfigPlace&) const = default;
  /// Position of the slave it belongs to, -1 for what belongs to none.
  [[nodiscard]] int slave() const;
};

/// Where a finding belongs: as much of it as its finder knows.
struct Place {
  int slave = -1;      // position; -1: the master, the bus or all
  std::string key;     // the setting that cures it, as `synclinectl project keys` names it: "slave.3.dc.op_mode"
  ConfigPlace part;    // the thing of the configuration
  std::string file;    // of what was read
  int line = 0;        // in the file, from 1; 0 = the file as a whole, or no file
  std::string path{};  // "/EtherCATConfig/Config/Slave[2]/InitCmds/InitCmd[5]"

  Place() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a slave is a place.
  Place(int position, std::string setting = {}) : slave(position), key(std::move(setting)) {}
  bool operator==(const Place&) const = default;
};

}  // namespace syncline
