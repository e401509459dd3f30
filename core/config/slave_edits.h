// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "support/expected.h"

/// Slaves come, go and change their places. Whatever says a slave by its number (where another one hangs, the reference
/// clock) stays with the slave; station addresses stay unique. The slaves stand in the order of the frame afterwards,
/// where they did before; a project whose order is not what its wiring says keeps its order as far as it can. A slave
/// goes with its branches (wiring_tree.h). Pure: what fails leaves the project as it was.
namespace syncline {

struct DeviceDescription;
struct PreviousPort;
struct Project;

enum class WiringObstacle : std::uint8_t {
  kNoSuchSlave,
  kNoPort,     // no free port there or further up that the device could be plugged into
  kPortTaken,  // something hangs there already
  kOtherKind,  // a cable port for a terminal or the other way round
  kNoWayOn,    // the slave has no port for those that would have to hang behind it
  kBehindIt,   // the place is behind the slave itself
  kFirst,      // it stands first in its line, or where only the master is before it
  kLast,       // it stands last in its line
  kTooMany,    // more slaves than EtherCAT has addresses
};
/// Position at which the slave now stands.
using EditedSlave = Expected<std::size_t, WiringObstacle>;

/// A new slave behind another one: it goes on its line, or into a branch that it fits (a terminal to the terminals of a
/// coupler, at the end), or behind the nearest slave towards the master that has a port for it. `behind` empty: behind
/// the last slave.
[[nodiscard]] EditedSlave add_slave(Project& project, const DeviceDescription& device,
                                    std::optional<std::size_t> behind);
/// A new slave in the place of `target`, which hangs behind it then, or, where that place does not take it, at the end
/// of the line that ends just before `target`. Never anywhere else.
[[nodiscard]] EditedSlave add_slave_before(Project& project, const DeviceDescription& device, std::size_t target);
/// A new slave at a free port.
[[nodiscard]] EditedSlave add_slave_at(Project& project, const DeviceDescription& device, PreviousPort at);
/// The slave with its branches goes, its line closes. The position that is next then; 0 for none.
[[nodiscard]] EditedSlave remove_slave(Project& project, std::size_t slave);
/// A copy of the slave with its branches, behind it: without alias, with names and addresses of its own.
[[nodiscard]] EditedSlave duplicate_slave(Project& project, std::size_t slave);
/// The slave with its branches goes to the place where a new one would go.
[[nodiscard]] EditedSlave move_slave_behind(Project& project, std::size_t slave, std::size_t target);
/// The slave with its branches goes where a new one would go.
[[nodiscard]] EditedSlave move_slave_before(Project& project, std::size_t slave, std::size_t target);
/// The slave with its branches goes to the master, before all others.
[[nodiscard]] EditedSlave move_slave_first(Project& project, std::size_t slave);
/// Changes places with the slave before or behind it in its line.
[[nodiscard]] EditedSlave move_slave_up(Project& project, std::size_t slave);
[[nodiscard]] EditedSlave move_slave_down(Project& project, std::size_t slave);
/// The cable to the slave, with all that is behind it, goes to another free port.
[[nodiscard]] EditedSlave rewire_slave(Project& project, std::size_t slave, PreviousPort at);
/// Whether rewire_slave() would do it; fast, for each move of a mouse.
[[nodiscard]] std::optional<WiringObstacle> rewire_obstacle(const class WiringTree& tree, std::size_t slave,
                                                            PreviousPort at);
/// Whether add_slave_at() would do it, but for the number of slaves; as fast.
[[nodiscard]] std::optional<WiringObstacle> plug_obstacle(const class WiringTree& tree, const DeviceDescription& device,
                                                          PreviousPort at);

/// `wanted`, or the next address that is neither none nor in `used`; it is used then.
[[nodiscard]] std::uint16_t take_address(std::set<std::uint16_t>& used, std::uint16_t wanted);
/// `wanted`, or with a number behind it where it is among `names`; it is one of them then.
[[nodiscard]] std::string take_name(std::set<std::string>& names, const std::string& wanted);
/// Name that default_slave() gives.
[[nodiscard]] std::string default_name(std::uint16_t station_address, const DeviceDescription& device);

}  // namespace syncline
