// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}  // namespace CLI

/// The sub-commands of `synclinectl esi`, one file each.
namespace syncline::cli {

class Context;

void add_esi_index(CLI::App& esi, Context& context);
void add_esi_search(CLI::App& esi, Context& context);
void add_esi_show(CLI::App& esi, Context& context);
void add_esi_match(CLI::App& esi, Context& context);
void add_esi_try(CLI::App& esi, Context& context);

}  // namespace syncline::cli
