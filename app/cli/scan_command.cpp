// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/composition/scan_bus.h"
#include "config/device_description.h"

namespace syncline::cli {
namespace {

std::string_view dc_text(DcCapability dc) {
  switch (dc) {
    case DcCapability::kNone: return "no";
    case DcCapability::kReceiveTimesOnly: return "times";
    case DcCapability::kSystemTime32: return "32bit";
    case DcCapability::kSystemTime64: return "64bit";
  }
  return "no";
}

std::string name_of(const ScannedSlave& slave) {
  if (!slave.sii || !slave.sii->general) return {};
  const auto& general = *slave.sii->general;
  return general.order.empty() ? general.name : general.order;
}

Json to_json(const ScannedSlave& slave) {
  Json row{{"position", slave.position},
           {"name", name_of(slave)},
           {"vendor_id", hex(slave.identity.vendor_id, 8)},
           {"product_code", hex(slave.identity.product_code, 8)},
           {"revision_no", hex(slave.identity.revision_no, 8)},
           {"serial_no", slave.identity.serial_no},
           {"alias", slave.alias},
           {"state", al_state_name(al_state_of(slave.al_status))},
           {"dc", dc_text(slave.dc)},
           {"dl_status", hex(slave.dl_status.value, 4)}};
  if (slave.previous) row["previous"] = {{"position", slave.previous->position}, {"port", slave.previous->port}};
  return row;
}

void scan(Context& context, const std::string& link, bool json) {
  const auto found = scan_bus(link);
  if (!found) return context.fail_with(found.error());
  for (const auto& slave : found->slaves) {
    if (slave.sii_error) context.warn(*slave.sii_error);
  }
  if (json) {
    Json rows = Json::array();
    for (const auto& slave : found->slaves) rows.push_back(to_json(slave));
    return context.print({{"link", link}, {"slaves", rows}});
  }
  auto& out = context.console.out;
  out << fmt::format("{:>3} {:<12} {:<32} {:>6} {:<7} {:<6} {}\n", "POS", "NAME", "VENDOR:PRODUCT:REVISION", "ALIAS",
                     "STATE", "DC", "BEHIND");
  for (const auto& slave : found->slaves) {
    const auto behind = slave.previous ? fmt::format("{} port {}", slave.previous->position,
                                                     std::string(1, static_cast<char>('A' + slave.previous->port)))
                                       : std::string("master");
    out << fmt::format("{:>3} {:<12} {:<32} {:>6} {:<7} {:<6} {}\n", slave.position, name_of(slave),
                       to_string(slave.identity), slave.alias, al_state_name(al_state_of(slave.al_status)),
                       dc_text(slave.dc), behind);
  }
  out << fmt::format("{} slaves\n", found->slaves.size());
}

}  // namespace

void add_scan_command(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("scan", "List the slaves on a bus");
  struct Options {
    std::string link;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("link", options->link, "LINK")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { scan(context, options->link, options->json); });
}

}  // namespace syncline::cli
