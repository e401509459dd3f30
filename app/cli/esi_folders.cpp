// SPDX-License-Identifier: Apache-2.0
#include "app/cli/esi_folders.h"

#include <fmt/format.h>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/options.h"
#include "app/composition/open_link.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/catalogue/usual_sources.h"
#include "eni/xml/file_warning.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "findings/finding.h"

namespace syncline::cli {
void add_esi_folders(CLI::App& command, EsiFolders& options) {
  command.add_option("--esi", options.folders, "Folder of ESI files, repeatable (otherwise those indexed before)");
  command.add_option("--cache", options.cache, "Database of the catalogue (otherwise in the user's cache folder)");
}

void add_files(CommandFiles& files, const EsiFolders& options) {
  for (const auto& folder : options.folders) files.reads_esi("--esi", folder);
  files.writes_database("--cache", options.cache);
}

Result<eni::EsiCatalogue> open_catalogue(Context& context, const EsiFolders& options) {
  auto catalogue = options.cache.empty() ? Result<eni::EsiCatalogue>(eni::EsiCatalogue::open_default())
                                         : eni::EsiCatalogue::open(options.cache);
  if (!catalogue) return catalogue;
  const auto folders =
      options.folders.empty() ? eni::usual_sources(*catalogue, {resource_folder() + "/esi"}) : options.folders;
  for (const auto& folder : folders) {
    const auto report = eni::add_source(*catalogue, folder);
    if (!report && !options.folders.empty()) return tl::unexpected(report.error());
    if (!report) context.warn(report.error());  // nobody asked for this very folder
    for (const auto& error : report ? eni::unreadable_folders(*report) : std::vector<Error>{}) context.warn(error);
  }
  for (const auto& note : catalogue->notes())
    context.console.err << "note: " << note.file << ": " << note.reason.text() << '\n';
  return catalogue;
}

Json entry_json(const eni::CatalogueEntry& entry) {
  return {{"vendor_id", hex(entry.identity.vendor_id, 8)},
          {"product_code", hex(entry.identity.product_code, 8)},
          {"revision_no", hex(entry.identity.revision_no, 8)},
          {"vendor", entry.vendor_name},
          {"type", std::string(eni::trim(entry.type))},
          {"name", entry.name},
          {"group_type", entry.group_type},
          {"group", entry.group_name},
          {"physics", entry.physics},
          {"revision_rule", entry.revision_rule.empty() ? Json(nullptr) : Json(entry.revision_rule)},
          {"hidden", entry.hidden},
          {"file", entry.file},
          {"line", entry.line}};
}

Json match_json(const Result<eni::CatalogueMatch>& match) {
  return {{"match", match ? Json(eni::match_kind_name(match->kind)) : Json(nullptr)},
          {"words", match ? match->words : describe(match.error())},
          {"device", match ? entry_json(match->entry) : Json(nullptr)}};
}

std::string entry_line(const eni::CatalogueEntry& entry) {
  return fmt::format("{:08x}:{:08x}:{:08x}  {:<18} {}{}", entry.identity.vendor_id, entry.identity.product_code,
                     entry.identity.revision_no, eni::trim(entry.type), entry.name, entry.hidden ? " (hidden)" : "");
}

}  // namespace syncline::cli
