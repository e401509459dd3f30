// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "eni/catalogue/esi_catalogue.h"

namespace CLI {
class App;
}  // namespace CLI

/// Which ESI files a command looks into: the options --esi and --cache.
namespace syncline::cli {

struct EsiFolders {
  std::vector<std::string> folders;  // empty: those of `esi index`, and our own simulated devices
  std::string cache;                 // database; "" = the user's
};

void add_esi_folders(CLI::App& command, EsiFolders& options);
/// What they read and write.
void add_files(CommandFiles& files, const EsiFolders& options);

/// Opens the catalogue and brings it up to date. Says on the error stream what the user should know (a database that
/// was made again); files that cannot be read stay in EsiCatalogue::warnings().
[[nodiscard]] Result<eni::EsiCatalogue> open_catalogue(Context& context, const EsiFolders& options);

/// What list and search show of a device.
[[nodiscard]] Json entry_json(const eni::CatalogueEntry& entry);
/// `match` (null without one), `words`, `device`.
[[nodiscard]] Json match_json(const Result<eni::CatalogueMatch>& match);
[[nodiscard]] std::string entry_line(const eni::CatalogueEntry& entry);

}  // namespace syncline::cli
