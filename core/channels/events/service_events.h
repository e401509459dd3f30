// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "support/result.h"

/// About the master itself.
namespace syncline::events {

/// What of SCHED_FIFO, locked memory and processor was refused; once.
struct RealTimeRefused {
  std::string what;
};

/// Somebody forced outputs or released them. ForceOutputCommand.
struct OutputsForced {
  std::uint32_t bits = 0;  // that are forced now
};

/// A command, or what runs, failed.
struct Failure {
  Error error;
};

/// By something that should not have happened; the bus is taken down.
struct MasterStopped {
  std::string text;
};

/// The queue was full.
struct EventsLost {
  std::uint64_t count = 0;
};

}  // namespace syncline::events
