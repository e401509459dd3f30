// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "eni/catalogue/catalogue_entry.h"
#include "support/result.h"

/// Brings the index up to date with the files: only what changed is read again.
namespace syncline::eni {

class CatalogueStore;

/// Every *.xml below the folder, in the order of their paths; all are chosen for searching. Size and modification time
/// say whether a file may have changed, its content whether it did. A file that cannot be read becomes a problem in the
/// store; kFileNotFound and kFileNotReadable when it is the folder, kCatalogue when the store fails.
[[nodiscard]] Result<IndexReport> update_folder(CatalogueStore& store, const std::string& folder,
                                                const IndexCallback& callback = {});
/// One file, whatever its name; errors of the file are errors here.
[[nodiscard]] Status update_file(CatalogueStore& store, const std::string& path);

}  // namespace syncline::eni
