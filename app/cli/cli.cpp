// SPDX-License-Identifier: Apache-2.0
#include "app/cli/cli.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/context.h"
#include "protocol/error_text.h"

namespace syncline::cli {

void Context::fail_with(const Error& error) {
  console.err << "synclinectl: " << describe(error) << '\n';
  const bool usage = error.code == ErrorCode::kBadValue || error.code == ErrorCode::kUnknownKey;
  exit_code = usage ? kUsage : kFailed;
}

void Context::warn(const Error& error) { console.err << "warning: " << describe(error) << '\n'; }

std::string hex(std::uint64_t value, int digits) { return fmt::format("0x{:0{}x}", value, digits); }

std::string mac_text(const std::array<std::uint8_t, 6>& mac) {
  return fmt::format("{:02x}:{:02x}:{:02x}:{:02x}:{:02x}:{:02x}", mac[0], mac[1], mac[2], mac[3], mac[4], mac[5]);
}

int run(const std::vector<std::string>& arguments, Console console) {
  Context context{console};
  CLI::App app{
      "synclinectl: EtherCAT configurator and synchronisation monitor without a window.\n"
      "LINK is sim:FILE[?virtual][&seed=N], nic:NAME or replay:FILE (a capture).\n"
      "Exit codes: 0 done, 1 the answer is no, 2 usage, 3 bus or file error.",
      "synclinectl"};
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("synclinectl ") + SYNCLINE_VERSION);
  add_adapters_command(app, context);
  add_scan_command(app, context);
  add_sii_command(app, context);
  add_sdo_command(app, context);
  add_foe_command(app, context);
  add_slave_commands(app, context);
  add_sync_command(app, context);
  add_dc_command(app, context);
  add_project_commands(app, context);
  add_esi_commands(app, context);
  add_export_command(app, context);
  add_check_command(app, context);
  add_compare_command(app, context);
  add_run_command(app, context);
  add_simulate_command(app, context);

  auto reversed = arguments;  // CLI11 takes them last first
  std::reverse(reversed.begin(), reversed.end());
  try {
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error, console.out, console.err);
    return code == 0 ? kDone : kUsage;
  }
  return context.exit_code;
}

}  // namespace syncline::cli
