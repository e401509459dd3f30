// SPDX-License-Identifier: Apache-2.0
#include "app/cli/esi_command.h"

#include "app/cli/context.h"
#include "app/cli/options.h"

namespace syncline::cli {

void add_esi_commands(CLI::App& app, Context& context) {
  auto* esi = app.add_subcommand("esi", "Find devices in folders of ESI files");
  esi->require_subcommand(1);
  add_esi_index(*esi, context);
  add_esi_search(*esi, context);
  add_esi_show(*esi, context);
  add_esi_match(*esi, context);
  add_esi_try(*esi, context);
}

}  // namespace syncline::cli
