// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "config/network_config.h"
#include "master/exchange/run_state.h"
#include "support/result.h"

namespace syncline {

class Bus;
class SlaveCommands;

/// Who of the configuration is on the bus at start-up, and where; what differs is told by error events.
class Attendance {
 public:
  Attendance(Bus& bus, RunState& run, SlaveCommands& commands)
      : bus_(bus), run_(run), commands_(commands), missing_(run.config().slaves.size()) {}

  /// `count` slaves answer. Looks closer where that is not the configuration, or where slaves may stand anywhere; those
  /// that are there are noted with their places. kSlaveCount and the differences that the configuration does not allow.
  Status check(std::uint16_t count);
  /// Why a bus of the configured size was refused with `status`: tells who is another, swapped or missing. Gives
  /// `status`.
  Status explain_refusal(Status status);
  [[nodiscard]] bool missing(std::size_t slave) const { return missing_[slave]; }
  [[nodiscard]] bool complete() const;

 private:
  struct Differences {
    bool allowed = false;       // the bus may be started with who is there
    std::vector<Error> errors;  // told
  };
  Result<Differences> look(std::uint16_t count);

  Bus& bus_;
  RunState& run_;
  SlaveCommands& commands_;
  std::vector<bool> missing_;
};

}  // namespace syncline
