// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Option.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/cli.h"
#include "support/result.h"

namespace syncline::cli {

/// Keys keep the order in which they are written, so that the output is stable and readable.
using Json = nlohmann::ordered_json;

/// What a sub-command needs and leaves behind.
struct Context {
  Console console;
  int exit_code = kDone;

  /// Prints the error and sets the exit code: 2 for a key or value that is not accepted, else 3.
  void fail_with(const Error& error);
  void warn(const Error& error);
  void print(const Json& json) { console.out << json.dump(2) << '\n'; }
};

void add_adapters_command(CLI::App& app, Context& context);
void add_scan_command(CLI::App& app, Context& context);
void add_sii_command(CLI::App& app, Context& context);
void add_sdo_command(CLI::App& app, Context& context);
void add_foe_command(CLI::App& app, Context& context);
void add_slave_commands(CLI::App& app, Context& context);
void add_sync_command(CLI::App& app, Context& context);
void add_dc_command(CLI::App& app, Context& context);
void add_project_commands(CLI::App& app, Context& context);
void add_esi_commands(CLI::App& app, Context& context);
void add_export_command(CLI::App& app, Context& context);
void add_check_command(CLI::App& app, Context& context);
void add_compare_command(CLI::App& app, Context& context);
void add_run_command(CLI::App& app, Context& context);
void add_simulate_command(CLI::App& app, Context& context);

[[nodiscard]] std::string hex(std::uint64_t value, int digits);
[[nodiscard]] std::string mac_text(const std::array<std::uint8_t, 6>& mac);

}  // namespace syncline::cli
