// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/result.h"

namespace syncline {
class SqlDatabase;
}  // namespace syncline

namespace syncline::eni {

/// Opens a catalogue's database and makes its tables where it is new; see CatalogueStore::open.
[[nodiscard]] Result<SqlDatabase> open_catalogue_database(const std::string& path, Reason& replaced);

}  // namespace syncline::eni
