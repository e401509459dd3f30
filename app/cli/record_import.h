// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}  // namespace CLI

namespace syncline::cli {

class Context;

/// "record import": a recording of a capture, a log of the master synchronisation or a table of a run. Exit code 1
/// where something of the file was left out.
void add_import_command(CLI::App& group, Context& context);

}  // namespace syncline::cli
