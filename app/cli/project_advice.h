// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/context.h"

namespace CLI {
class App;
}  // namespace CLI

namespace syncline::cli {

/// `project cycle-times` and `project report`: what the project's bus can do and what it costs.
void add_project_advice(CLI::App& project, Context& context);

}  // namespace syncline::cli
