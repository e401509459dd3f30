// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}  // namespace CLI

namespace syncline::cli {

class Context;

/// "record plot": signals of a recording over time, drawn as SVG without a window.
void add_plot_command(CLI::App& group, Context& context);

}  // namespace syncline::cli
