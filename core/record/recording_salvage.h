// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "channels/cycle_sample.h"
#include "sqlite/sqlite_database.h"
#include "support/result.h"

namespace syncline {

/// What could be read of a recording that SQLite refuses: the rows that are as they were written, in a database of its
/// own, which goes with it.
struct SalvagedRecording {
  SqlDatabase database;                          // its path() is that of the recording
  std::uint64_t bytes = 0, bytes_said = 0;       // that are there, and that there were; 0: not known
  std::uint64_t blocks = 0;                      // none of whose values are there: they are left out
  std::int64_t first_cycle = 0, last_cycle = 0;  // of these
  Nanoseconds begin = 0, end = 0;
};

/// kFileNotReadable: it is no recording whose rows have checks (kFirstWithChecks), or what it cannot do without is
/// gone.
[[nodiscard]] Result<SalvagedRecording> salvage_recording(const std::string& path);

}  // namespace syncline
