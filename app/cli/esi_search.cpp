// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/context.h"
#include "app/cli/esi_command.h"
#include "app/cli/esi_folders.h"
#include "app/cli/options.h"
#include "eni/catalogue/catalogue_entry.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

struct SearchOptions {
  std::vector<std::string> words;
  eni::CatalogueSearch search;
  EsiFolders esi;
  bool json = false;
};

void search(Context& context, SearchOptions& options) {
  const auto catalogue = open_catalogue(context, options.esi);
  if (!catalogue) return context.fail_with(catalogue.error());
  for (const auto& word : options.words) options.search.words += (options.search.words.empty() ? "" : " ") + word;
  const auto found = catalogue->search(options.search);
  if (!found) return context.fail_with(found.error());
  if (found->empty()) context.exit_code = kAnswerIsNo;
  if (options.json) {
    Json devices = Json::array();
    for (const auto& entry : *found) devices.push_back(entry_json(entry));
    return context.print({{"words", options.search.words}, {"devices", devices}});
  }
  for (const auto& entry : *found) context.console.out << entry_line(entry) << '\n';
  if (found->empty()) context.console.out << "none of " << counted(catalogue->device_count(), "device") << '\n';
}

}  // namespace

void add_esi_search(CLI::App& esi, Context& context) {
  auto* command = esi.add_subcommand("search",
                                     "List the devices that have all the words, or beginnings of them, in their type, "
                                     "name, vendor or group");
  auto options = std::make_shared<SearchOptions>();
  command->add_option("words", options->words, "Words; none lists every device");
  command->add_option("--vendor", options->search.vendor_id, "Vendor id");
  command->add_option("--group", options->search.group_type, "Group, by its Type");
  command->add_flag("--all", options->search.all_revisions, "Every revision, not only the newest");
  command->add_flag("--hidden", options->search.with_hidden, "Also devices that a newer one hides");
  command->add_option("--limit", options->search.limit, "How many at most")->capture_default_str();
  add_esi_folders(*command, options->esi);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { search(context, *options); });
}

}  // namespace syncline::cli
