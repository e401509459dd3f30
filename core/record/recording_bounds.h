// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

/// How far a recording may go, and how it is written.
struct RecordingBounds {
  std::uint64_t most_bytes = 0;                  // of the file; 0: as much as the disk has
  Nanoseconds longest = 0;                       // of the run; 0: until the end
  std::uint64_t keep_free_bytes = 256ULL << 20;  // of the disk: others need it, too
  bool wait_for_disk = true;                     // false: what the disk is too slow for is lost, and counted
  Nanoseconds commit_every = kSecond;            // of the run's time
  bool by_clock = true;                          // commits also when nothing has come for so long; not on virtual time
};

/// A recording ends before its run does.
struct RecordingStop {
  std::string why;
  std::optional<Error> error;  // kFileNotWritable: the disk is full or fails; none: a bound that was asked for
};

}  // namespace syncline
