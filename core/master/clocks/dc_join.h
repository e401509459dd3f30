// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "support/result.h"

namespace syncline {

class Bus;
class ClockFeed;
struct NetworkConfig;
struct Snapshot;
class SyncWatch;
enum class DcLoopRole : std::uint8_t;

/// Sets the clocks of slaves that join a bus whose clocks run already, without a word to the others: each
/// is read together with the leading clock in one frame, and the offset is what they differ by (a clock
/// that is read shows what the leader showed when that frame passed it, as far as its propagation delay is
/// right). The delay is that of the initialisation: the slave hangs where it hung. The time control loop gets the
/// values of the initialisation, and learns the quartz by a short burst.
class DcJoin {
 public:
  /// `home`: position of the clock that is to lead, whose loop has values of its own.
  DcJoin(Bus& bus, const NetworkConfig& config, const Snapshot& snapshot, const SyncWatch& sync, ClockFeed& feed,
         std::uint16_t home)
      : bus_(bus), config_(config), snapshot_(snapshot), sync_(sync), feed_(feed), home_(home) {}

  /// `leader`: position of the slave that leads; empty: the master's own idea of the time. Then waits until the
  /// clocks run with the leader's, some seconds at most. Slaves without a system time are left out. Bus errors.
  Status run(std::span<const std::size_t> slaves, std::optional<std::uint16_t> leader);

 private:
  Status set_clock(std::size_t slave, bool wide, std::optional<std::uint16_t> leader);
  [[nodiscard]] DcLoopRole role_of(std::size_t slave, std::optional<std::uint16_t> leader) const;
  Status set_loop(std::size_t slave, DcLoopRole role);
  Status await(std::span<const std::size_t> slaves, std::optional<std::uint16_t> leader);

  Bus& bus_;
  const NetworkConfig& config_;
  const Snapshot& snapshot_;
  const SyncWatch& sync_;
  ClockFeed& feed_;
  std::uint16_t home_;
};

}  // namespace syncline
