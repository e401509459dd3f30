// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace CLI {
class App;
}  // namespace CLI

namespace syncline::cli {

class Context;

/// "record report": the page that is handed over with a machine. Exit code 1 where the run is not accepted.
void add_report_command(CLI::App& group, Context& context);

}  // namespace syncline::cli
