// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sqlite/sqlite_database.h"

namespace syncline::test {

/// Makes one of an older version (4 at most) of a recording: its rows have no checks, and nobody has counted them.
inline Status make_older(const std::string& path, int version) {
  auto database = SqlDatabase::open(path);
  if (!database) return tl::unexpected(database.error());
  for (const std::string table : {"meta", "document", "limits", "slave", "signal", "series", "variable", "watch_list",
                                  "block", "summary", "data", "event", "finding", "note"}) {
    if (auto status = database->execute(("ALTER TABLE " + table + " DROP COLUMN crc").c_str()); !status) return status;
  }
  return database->execute(("ALTER TABLE data DROP COLUMN levels_crc; ALTER TABLE block DROP COLUMN held; "
                            "ALTER TABLE block DROP COLUMN sums; DROP TABLE tally; PRAGMA user_version = " +
                            std::to_string(version))
                               .c_str());
}

}  // namespace syncline::test
