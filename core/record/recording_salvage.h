// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "sqlite/sqlite_database.h"
#include "support/result.h"

namespace syncline {

/// What could be read of a recording that SQLite refuses: the rows that are as they were written, in a database of its
/// own, which goes with it.
struct SalvagedRecording {
  SqlDatabase database;                     // its path() is that of the recording
  std::uint64_t bytes = 0, bytes_said = 0;  // that are there, and that there were; 0: not known
  std::uint64_t cycles = 0;                 // of the blocks that are whole
  std::uint64_t blocks_lost = 0;            // of which there is nothing; the others are gaps
};

/// kFileNotReadable: it is no recording whose rows have checks (kFirstWithChecks), or what it cannot do without is
/// gone.
[[nodiscard]] Result<SalvagedRecording> salvage_recording(const std::string& path);

}  // namespace syncline
