// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "eni/catalogue/esi_catalogue.h"

namespace syncline::eni {

/// What the catalogue looks into when nobody names anything: folders and files that the user had it remember, as far as
/// they are still there, and behind them `own`.
[[nodiscard]] std::vector<std::string> usual_sources(const EsiCatalogue& catalogue, std::vector<std::string> own);

/// A folder, or one file.
[[nodiscard]] Status add_source(EsiCatalogue& catalogue, const std::string& path, const IndexCallback& callback = {});

/// All usual sources; those that cannot be read are told. Ends early when `callback` says so.
std::vector<Error> add_usual_sources(EsiCatalogue& catalogue, std::vector<std::string> own,
                                     const IndexCallback& callback = {});

}  // namespace syncline::eni
