// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "master/exchange/slave_address.h"

namespace syncline {

class Bus;
class CyclicTaskRunner;
class DelayCompensation;
class EventTeller;
struct NetworkConfig;
struct Snapshot;

/// Measures the propagation delays anew when slaves have gone or come: frames take another way then, and those behind
/// follow the reference clock with a delay that is not theirs any more, which their own readings (0x092C) soon do not
/// show. Who is on the bus is read in frame order, so that it does not matter where a hot-connect group stands.
class DelayRenewal {
 public:
  DelayRenewal(Bus& bus, const NetworkConfig& config, const Snapshot& snapshot, EventTeller& teller,
               CyclicTaskRunner& task, DelayCompensation& delays)
      : bus_(bus), config_(config), snapshot_(snapshot), teller_(teller), task_(task), delays_(delays) {}

  /// After a bus cycle; does nothing (and allocates nothing) as long as nobody has moved. Waits until all have been
  /// quiet for a second and everybody who answers is known; cycles go on while it measures. Bus errors; kCancelled when
  /// a command of the user came in between: it is tried again.
  Status after_cycle();

 private:
  struct Members {
    std::vector<std::size_t> slaves;  // positions in the configuration, in frame order
    std::vector<SlaveAddress> addresses;
  };
  [[nodiscard]] Nanoseconds last_move() const;
  [[nodiscard]] bool all_known() const;
  Status measure(std::uint16_t leader);
  Result<std::optional<Members>> read_members();

  Bus& bus_;
  const NetworkConfig& config_;
  const Snapshot& snapshot_;
  EventTeller& teller_;
  CyclicTaskRunner& task_;
  DelayCompensation& delays_;
  Nanoseconds next_look_ = 0;
};

}  // namespace syncline
