// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/esi_folders.h"
#include "app/cli/event_text.h"
#include "app/cli/findings_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/composition/open_link.h"
#include "channels/event.h"
#include "config/device_description.h"
#include "engine/opened_link.h"
#include "engine/scan_bus.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "protocol/al_state.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

std::string_view dc_text(DcCapability dc) {
  switch (dc) {
    case DcCapability::kNone:
      return "no";
    case DcCapability::kReceiveTimesOnly:
      return "times";
    case DcCapability::kSystemTime32:
      return "32bit";
    case DcCapability::kSystemTime64:
      return "64bit";
  }
  return "no";
}

std::string name_of(const ScannedSlave& slave) {
  if (!slave.sii || !slave.sii->general) return {};
  const auto& general = *slave.sii->general;
  return general.order.empty() ? general.name : general.order;
}

Json ports_json(const DlStatus& status) {
  Json ports = Json::array();
  for (unsigned port = 0; port < kPortCount; ++port) {
    ports.push_back({{"link", status.physical_link(port)}, {"open", status.active(port)}});
  }
  return ports;
}

/// Null for what a capture does not say.
template <class Value>
Json known(bool unknown, Value value) {
  return unknown ? Json() : Json(std::move(value));
}

Json scanned_json(const ScannedSlave& slave) {
  const auto& unknown = slave.unknown;
  Json row{{"position", slave.position},
           {"name", name_of(slave)},
           {"vendor_id", known(unknown.vendor_id, hex(slave.identity.vendor_id, 8))},
           {"product_code", known(unknown.product_code, hex(slave.identity.product_code, 8))},
           {"revision_no", known(unknown.revision_no, hex(slave.identity.revision_no, 8))},
           {"serial_no", known(unknown.serial_no, slave.identity.serial_no)},
           {"alias", known(unknown.alias, slave.alias)},
           {"state", known(unknown.state, al_state_name(al_state_of(slave.al_status)))},
           {"dc", known(unknown.dc, dc_text(slave.dc))},
           {"dl_status", known(unknown.ports, hex(slave.dl_status.value, 4))}};
  if (slave.previous) row["previous"] = {{"position", slave.previous->position}, {"port", slave.previous->port}};
  row["station_address"] = slave.station_address;
  row["device_id"] = slave.device_id ? Json(*slave.device_id) : Json();
  row["error"] = known(unknown.state, (slave.al_status & kAlErrorFlag) != 0);
  row["al_status_code"] = known(unknown.state, hex(slave.al_status_code, 4));
  row["entry_port"] = known(unknown.ports, slave.entry_port);
  row["ports"] = known(unknown.ports, ports_json(slave.dl_status));
  row["sii_error"] = slave.sii_error ? Json(describe(*slave.sii_error)) : Json();
  return row;
}

constexpr std::string_view kUnknown = "unknown";

/// "0x00000002:0x044c2c52:unknown".
std::string identity_of(const ScannedSlave& slave) {
  const auto& unknown = slave.unknown;
  if (!unknown.vendor_id && !unknown.product_code && !unknown.revision_no) return to_string(slave.identity);
  const auto part = [](bool is_unknown, std::uint32_t value) {
    return is_unknown ? std::string(kUnknown) : hex(value, 8);
  };
  return fmt::format("{}:{}:{}", part(unknown.vendor_id, slave.identity.vendor_id),
                     part(unknown.product_code, slave.identity.product_code),
                     part(unknown.revision_no, slave.identity.revision_no));
}

/// "AB" when ports A and B are open, "a" for a link that frames do not pass.
std::string ports_text(const DlStatus& status) {
  std::string text;
  for (unsigned port = 0; port < kPortCount; ++port) {
    if (status.active(port)) {
      text += static_cast<char>('A' + port);
    } else if (status.physical_link(port)) {
      text += static_cast<char>('a' + port);
    }
  }
  return text;
}

std::string state_of(const ScannedSlave& slave) {
  if (slave.unknown.state) return std::string(kUnknown);
  return fmt::format("{}{}", al_state_name(al_state_of(slave.al_status)),
                     (slave.al_status & kAlErrorFlag) != 0 ? "+E" : "");
}

std::string behind_text(const BusScan& scan, const ScannedSlave& slave) {
  if (slave.unknown.ports && slave.position > 0) return std::string(kUnknown);
  if (!slave.previous) return slave.position == 0 || scan.slaves.size() == 1 ? "master" : "?";
  return fmt::format("{} port {}", slave.previous->position, static_cast<char>('A' + slave.previous->port));
}

void print_table(std::ostream& out, const BusScan& scan) {
  out << fmt::format("{:>4} {:<12} {:<32} {:>6} {:>6} {:<8} {:<6} {:<5} {}\n", "POS", "NAME", "VENDOR:PRODUCT:REVISION",
                     "ALIAS", "ID", "STATE", "DC", "PORTS", "BEHIND");
  for (const auto& slave : scan.slaves) {
    out << fmt::format("{:>4} {:<12} {:<32} {:>6} {:>6} {:<8} {:<6} {:<5} {}\n", slave.position, name_of(slave),
                       identity_of(slave), slave.unknown.alias ? "?" : fmt::to_string(slave.alias),
                       slave.device_id ? fmt::to_string(*slave.device_id) : "-", state_of(slave),
                       slave.unknown.dc ? "?" : dc_text(slave.dc),
                       slave.unknown.ports ? "?" : ports_text(slave.dl_status), behind_text(scan, slave));
  }
  out << fmt::format("{}{}\n", counted(scan.slaves.size(), "slave"), scan.look_only ? ", looked at only" : "");
}

struct ScanOptions {
  std::string link, capture;
  EsiFolders esi;
  bool look_only = false, json = false;

  [[nodiscard]] bool looks_up() const { return !esi.folders.empty() || !esi.cache.empty(); }
};

/// Which ESI device describes each slave, for the commands that make projects of them.
void print_matches(std::ostream& out, const BusScan& scan, const eni::EsiCatalogue& catalogue) {
  for (const auto& slave : scan.slaves) {
    const auto match = catalogue.match(slave.identity);
    out << (match ? fmt::format("{:>4} {}: {} ({}:{})\n", slave.position, eni::trim(match->entry.type), match->words,
                                match->entry.file, match->entry.line)
                  : fmt::format("{:>4} {}\n", slave.position, describe(match.error())));
  }
}

void scan(Context& context, const ScanOptions& options) {
  CommandFiles files;
  files.reads_link("link", options.link).writes("--capture", options.capture);
  add_files(files, options.esi);
  if (const auto distinct = files.check(); !distinct) return context.fail_with(distinct.error());
  const InterruptGuard interrupt;
  ScanRequest request;
  request.options.look_only = options.look_only;
  request.cancel = &interrupt.interrupted();
  request.capture = options.capture;
  request.on_capture_lost = [&context](const Error& error) { context.fail_with(error); };
  request.on_event = [&context](const Event& event) {
    if (!event.is<events::ScanTouchesRunning>()) return;
    context.console.err << "warning: " << event_text(event, event.time) << " (--look-only)\n" << std::flush;
  };
  const auto found = scan_bus(open_link(options.link), request);
  if (!found) return context.fail_with(found.error());
  for (const auto& slave : found->slaves) {
    if (slave.sii_error) context.warn(*slave.sii_error);
  }
  for (const auto& finding : found->findings) context.warn(finding);
  std::optional<eni::EsiCatalogue> catalogue;
  if (options.looks_up()) {
    auto opened = open_catalogue(context, options.esi);
    if (!opened) return context.fail_with(opened.error());
    catalogue = std::move(*opened);
  }
  if (!options.json) {
    print_table(context.console.out, *found);
    if (catalogue) print_matches(context.console.out, *found, *catalogue);
    return;
  }
  Json rows = Json::array(), findings = Json::array();
  for (const auto& slave : found->slaves) {
    rows.push_back(scanned_json(slave));
    if (catalogue) rows.back()["esi"] = match_json(catalogue->match(slave.identity));
  }
  for (const auto& finding : found->findings) findings.push_back(describe(finding));
  context.print({{"link", options.link},
                 {"slaves", rows},
                 {"look_only", found->look_only},
                 {"running", found->running},
                 {"findings", findings},
                 {"coded_findings", to_json(found->findings)}});
}

}  // namespace

void add_scan_command(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("scan", "List the slaves on a bus");
  auto options = std::make_shared<ScanOptions>();
  command->add_option("link", options->link, "LINK")->required();
  command->add_flag("--look-only", options->look_only,
                    "Change nothing: no station addresses, no EEPROM taken from its PDI, no latching of times");
  command->add_option("--capture", options->capture, "Write every frame to this pcapng file");
  add_esi_folders(*command, options->esi);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { scan(context, *options); });
}

}  // namespace syncline::cli
