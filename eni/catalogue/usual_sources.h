// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "eni/catalogue/catalogue_entry.h"
#include "support/result.h"

namespace syncline::eni {

class EsiCatalogue;

/// What the catalogue looks into when nobody names anything: folders and files that the user had it remember, as far as
/// they are still there, and behind them `own`.
[[nodiscard]] std::vector<std::string> usual_sources(const EsiCatalogue& catalogue, std::vector<std::string> own);

/// A folder, or one file. The report says what of it was not read; see unreadable_folders().
[[nodiscard]] Result<IndexReport> add_source(EsiCatalogue& catalogue, const std::string& path,
                                             const IndexCallback& callback = {});
/// The folders of a report that nobody may look into, an error each.
[[nodiscard]] std::vector<Error> unreadable_folders(const IndexReport& report);

/// All usual sources; what of them cannot be read is told. When `callback` says so no more is read; what was read at
/// earlier times is there all the same.
std::vector<Error> add_usual_sources(EsiCatalogue& catalogue, std::vector<std::string> own,
                                     const IndexCallback& callback = {});

}  // namespace syncline::eni
