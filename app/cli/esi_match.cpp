// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/context.h"
#include "app/cli/esi_command.h"
#include "app/cli/esi_folders.h"
#include "app/cli/identity_text.h"
#include "app/cli/options.h"
#include "config/device_description.h"
#include "config/identity.h"
#include "findings/error_text.h"

namespace syncline::cli {
namespace {

struct MatchOptions {
  std::string identity;
  EsiFolders esi;
  bool json = false;
};

void match(Context& context, const MatchOptions& options) {
  const auto identity = parse_identity(options.identity);
  if (!identity) return context.fail_with(identity.error());
  const auto catalogue = open_catalogue(context, options.esi);
  if (!catalogue) return context.fail_with(catalogue.error());
  const auto found = catalogue->match(*identity);
  if (!found && found.error().code != ErrorCode::kUnknownDevice) return context.fail_with(found.error());
  if (!found) context.exit_code = kAnswerIsNo;
  if (options.json) {
    Json json{{"identity", to_string(*identity)}};
    json.update(match_json(found));
    return context.print(json);
  }
  if (!found) {
    context.console.out << describe(found.error()) << '\n';
    return;
  }
  context.console.out << entry_line(found->entry) << '\n'
                      << found->words << '\n'
                      << found->entry.file << ':' << found->entry.line << '\n';
}

}  // namespace

void add_esi_match(CLI::App& esi, Context& context) {
  auto* command = esi.add_subcommand("match", "Say which ESI device describes an identity that was found on a bus");
  auto options = std::make_shared<MatchOptions>();
  command->add_option("identity", options->identity, "VENDOR:PRODUCT[:REVISION]")->required();
  add_esi_folders(*command, options->esi);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { match(context, *options); });
}

}  // namespace syncline::cli
