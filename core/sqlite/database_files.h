// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace syncline {

/// A database and what SQLite keeps beside it while it is open, and behind a program that was killed: log, index of the
/// log, journal. Whether they are there or not.
[[nodiscard]] std::vector<std::string> database_files(const std::string& path);
/// Removes them. A connection to the database must be closed before.
void remove_database(const std::string& path);
/// Of the database with its log; 0: there is none.
[[nodiscard]] std::uint64_t database_bytes(const std::string& path);

}  // namespace syncline
