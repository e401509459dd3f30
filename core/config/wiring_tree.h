// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "config/port_kind.h"
#include "config/previous_port.h"

/// Slaves as they hang at each other. A slave has a line that goes on behind it (the next coupler, the next terminal)
/// and branches (the terminals of a coupler, the cables of a junction): what belongs to it when somebody moves or
/// removes it.
namespace syncline {

struct DeviceDescription;
struct SlaveSettings;

struct WiredSlave {
  const DeviceDescription* device = nullptr;
  std::optional<PreviousPort> previous;
  std::uint8_t entry = 0;  // own port towards the master
};

class WiringTree {
 public:
  /// A slave that hangs at itself, at nobody that is there, at a port that no slave has or in a circle counts as one
  /// that hangs at nobody.
  explicit WiringTree(std::vector<WiredSlave> slaves);
  [[nodiscard]] static WiringTree of(const std::vector<SlaveSettings>& slaves);

  [[nodiscard]] const std::vector<WiredSlave>& slaves() const { return slaves_; }
  [[nodiscard]] std::optional<std::size_t> previous(std::size_t slave) const;
  /// Those that hang at the slave, in the order in which frames come to them.
  [[nodiscard]] const std::vector<std::size_t>& behind(std::size_t slave) const { return behind_[slave]; }
  [[nodiscard]] std::optional<std::size_t> at_port(std::size_t slave, std::uint8_t port) const;
  /// The slave that continues its line: the only one that hangs at a port like that by which the slave is entered.
  [[nodiscard]] std::optional<std::size_t> next(std::size_t slave) const;
  /// The slave that the line of this one branches off from; none on the line that begins at the master.
  [[nodiscard]] std::optional<std::size_t> branches_from(std::size_t slave) const;
  /// The slave and its branches, ascending; not what continues its line.
  [[nodiscard]] std::vector<std::size_t> group(std::size_t slave) const;
  /// A port of the slave at which nothing hangs and that is not the one towards the master.
  [[nodiscard]] bool is_free(std::size_t slave, std::uint8_t port) const;
  /// Port for the line to go on: that of next(), else the first free one like the entry.
  [[nodiscard]] std::optional<std::uint8_t> way_on(std::size_t slave) const;
  [[nodiscard]] PortKind entry_kind(std::size_t slave) const;
  /// All slaves in the order in which a frame passes their processing units. `at_master`: the one of those that hang at
  /// nobody that a frame comes to first; empty: the first of them.
  [[nodiscard]] std::vector<std::size_t> frame_order(std::optional<std::size_t> at_master = {}) const;

 private:
  void collect(std::size_t slave, std::vector<std::size_t>& into) const;

  std::vector<WiredSlave> slaves_;
  std::vector<std::vector<std::size_t>> behind_;
};

}  // namespace syncline
