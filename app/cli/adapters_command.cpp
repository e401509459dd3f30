// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/cli/options.h"
#include "app/composition/open_link.h"
#include "link/pcap_link.h"

namespace syncline::cli {
namespace {

void list(Context& context, bool json) {
  const auto adapters = list_adapters();
  if (!adapters) return context.fail_with(adapters.error());
  if (json) {
    Json rows = Json::array();
    rows.push_back(
        {{"link", demo_link(false)}, {"kind", "simulated"}, {"name", "demonstration machine"}, {"up", true}});
    for (const auto& adapter : *adapters) {
      rows.push_back({{"link", "nic:" + adapter.name},
                      {"kind", "nic"},
                      {"name", adapter.name},
                      {"up", adapter.up},
                      {"mac", mac_text(adapter.mac)},
                      {"driver", adapter.driver},
                      {"description", adapter.description}});
    }
    return context.print({{"adapters", rows}});
  }
  auto& out = context.console.out;
  out << fmt::format("{:<28} {:<5} {:<18} {}\n", "LINK", "STATE", "MAC", "DRIVER");
  out << fmt::format("{:<28} {:<5} {:<18} {}\n", demo_link(false), "up", "-", "simulated demonstration machine");
  for (const auto& adapter : *adapters) {
    out << fmt::format("{:<28} {:<5} {:<18} {}\n", "nic:" + adapter.name, adapter.up ? "up" : "down",
                       mac_text(adapter.mac), adapter.driver.empty() ? "-" : adapter.driver);
  }
}

}  // namespace

void add_adapters_command(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("adapters", "List the links that a bus can be on");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print JSON");
  command->callback([&context, json] { list(context, *json); });
}

}  // namespace syncline::cli
