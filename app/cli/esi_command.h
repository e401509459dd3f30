// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/context.h"

/// The sub-commands of `synclinectl esi`, one file each.
namespace syncline::cli {

void add_esi_index(CLI::App& esi, Context& context);
void add_esi_search(CLI::App& esi, Context& context);
void add_esi_show(CLI::App& esi, Context& context);
void add_esi_match(CLI::App& esi, Context& context);
void add_esi_try(CLI::App& esi, Context& context);

}  // namespace syncline::cli
