// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "config/slave_edits.h"
#include "config/wiring_tree.h"

namespace syncline {

struct DeviceDescription;
struct SlaveSettings;

/// The wiring of a project while it is changed. Slaves keep the numbers that they had, new ones get the next; only
/// order() says where they stand in the end. The devices must outlive it.
class WiringDraft {
 public:
  explicit WiringDraft(const std::vector<SlaveSettings>& slaves);

  /// A new slave that hangs at nobody yet; its number. `before`: number of the slave before which it stands as long as
  /// the order of the project is not that of its wiring.
  std::size_t add(const DeviceDescription& device, std::uint8_t entry, std::size_t before);
  /// Copies of a slave and its branches (ascending), wired among each other; the number of the first.
  std::size_t add_copies(std::span<const std::size_t> group, std::size_t before);
  /// Takes a slave with its branches out of its line, which closes.
  void detach(std::size_t slave);
  /// What was detached is gone.
  void drop(std::span<const std::size_t> group);
  /// Plugs in a detached slave; what hangs there hangs behind it then.
  [[nodiscard]] std::optional<WiringObstacle> attach(std::size_t slave, PreviousPort at);
  /// Gives a detached slave the place of another one, which hangs behind it then.
  [[nodiscard]] std::optional<WiringObstacle> attach_before(std::size_t slave, std::size_t displaced);
  /// Plugs a detached slave into the master; what hangs there hangs behind it then.
  [[nodiscard]] std::optional<WiringObstacle> attach_first(std::size_t slave);
  void hang(std::size_t slave, PreviousPort at);

  /// Where a detached slave goes that somebody puts behind another one; see add_slave().
  [[nodiscard]] std::optional<PreviousPort> place_behind(std::size_t target, std::size_t slave) const;
  /// Where a copy of a slave goes.
  [[nodiscard]] std::optional<PreviousPort> place_of_copy(std::size_t slave) const;

  [[nodiscard]] const std::vector<WiredSlave>& slaves() const { return slaves_; }
  [[nodiscard]] WiringTree tree() const { return WiringTree(slaves_); }
  /// Numbers of the slaves that are left, in the order of the frame. A project whose order is not what its wiring says
  /// keeps its order as far as it can.
  [[nodiscard]] std::vector<std::size_t> order() const;

 private:
  void insert(std::size_t slave, std::size_t before);
  std::optional<WiringObstacle> plug(std::size_t slave, std::optional<PreviousPort> at,
                                     std::optional<std::size_t> displaced);

  std::vector<WiredSlave> slaves_;
  std::vector<bool> gone_;
  std::vector<std::size_t> listed_;
  std::optional<std::size_t> at_master_;  // of those that hang at nobody; how others are reached nobody knows
  bool in_order_ = true;
};

}  // namespace syncline
