// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/esi_command.h"
#include "app/cli/identity_text.h"
#include "eni/esi_catalogue.h"

namespace syncline::cli {
namespace {

struct MatchOptions {
  std::string identity;
  std::vector<std::string> folders;
};

void match(Context& context, const MatchOptions& options) {
  const auto identity = parse_identity(options.identity);
  if (!identity) return context.fail_with(identity.error());
  eni::EsiCatalogue catalogue;
  for (const auto& folder : options.folders) {
    if (const auto status = catalogue.add_folder(folder); !status) return context.fail_with(status.error());
  }
  const auto found = catalogue.find(*identity);
  if (!found) return context.fail_with(Error{.code = ErrorCode::kUnknownDevice, .subject = to_string(*identity)});
  context.console.out << to_string(found->device->identity) << "  " << found->device->type << "  " << found->device->source
                      << '\n';
}

}  // namespace

void add_esi_match(CLI::App& esi, Context& context) {
  auto* command = esi.add_subcommand("match", "Say which ESI device describes a scanned identity");
  auto options = std::make_shared<MatchOptions>();
  command->add_option("identity", options->identity, "VENDOR:PRODUCT[:REVISION]")->required();
  command->add_option("--esi", options->folders, "Folder of ESI files, repeatable")->required();
  command->callback([&context, options] { match(context, *options); });
}

}  // namespace syncline::cli
