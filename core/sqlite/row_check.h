// SPDX-License-Identifier: Apache-2.0
#pragma once

struct sqlite3;

namespace syncline {

/// Gives a connection the SQL function row_crc(value, ...): CRC-32 (that of zlib) of the values, each by its type and
/// its bytes; see docs/recording.md. SQLite's code.
[[nodiscard]] int add_row_crc(sqlite3* database);

}  // namespace syncline
