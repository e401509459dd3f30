// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/cli/esi_command.h"
#include "app/cli/esi_folders.h"
#include "app/cli/identity_text.h"
#include "app/cli/options.h"
#include "config/device_description.h"
#include "eni/catalogue/catalogue_entry.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/xml/xml_text.h"

namespace syncline::cli {
namespace {

struct ShowOptions {
  std::string device;
  EsiFolders esi;
  bool json = false;
};

/// An identity, or the type as a catalogue or a label names it (its newest revision).
Result<eni::CatalogueEntry> find_entry(const eni::EsiCatalogue& catalogue, const std::string& text) {
  if (const auto identity = parse_identity(text)) {
    auto match = catalogue.match(*identity);
    if (!match) return tl::unexpected(match.error());
    return std::move(match->entry);
  }
  auto found = catalogue.search({.words = text, .with_hidden = true, .limit = 1});
  if (!found) return tl::unexpected(found.error());
  if (found->empty()) return fail(ErrorCode::kUnknownDevice, text);
  return std::move(found->front());
}

Json pdos_json(const std::vector<Pdo>& pdos) {
  Json rows = Json::array();
  for (const auto& pdo : pdos) {
    Json entries = Json::array();
    for (const auto& entry : pdo.entries) {
      entries.push_back({{"index", hex(entry.index, 4)},
                         {"sub_index", entry.sub_index},
                         {"bits", entry.bit_length},
                         {"type", entry.data_type},
                         {"name", entry.name}});
    }
    rows.push_back({{"index", hex(pdo.index, 4)},
                    {"name", pdo.name},
                    {"sync_manager", pdo.sync_manager ? Json(*pdo.sync_manager) : Json(nullptr)},
                    {"fixed", pdo.fixed},
                    {"mandatory", pdo.mandatory},
                    {"bits", pdo.bit_length()},
                    {"entries", entries}});
  }
  return rows;
}

Json device_json(const eni::CatalogueEntry& entry, const DeviceDescription& device) {
  auto json = entry_json(entry);
  Json mailbox = Json::array(), modes = Json::array();
  if (const auto& m = device.mailbox) {
    if (m->coe) mailbox.push_back("CoE");
    for (const auto& [has, name] :
         {std::pair{m->eoe, "EoE"}, {m->foe, "FoE"}, {m->soe, "SoE"}, {m->aoe, "AoE"}, {m->voe, "VoE"}}) {
      if (has) mailbox.push_back(name);
    }
  }
  if (device.dc) {
    for (const auto& mode : device.dc->op_modes) {
      modes.push_back(
          {{"name", mode.name}, {"description", mode.description}, {"assign_activate", hex(mode.assign_activate, 4)}});
    }
  }
  json["sync_managers"] = device.sync_managers.size();
  json["fmmus"] = device.fmmus.size();
  json["mailbox"] = mailbox;
  json["op_modes"] = modes;
  json["rx_pdos"] = pdos_json(device.rx_pdos);
  json["tx_pdos"] = pdos_json(device.tx_pdos);
  json["objects"] = device.dictionary.size();
  json["modules"] = device.modules.size();
  return json;
}

std::string flags_of(const Pdo& pdo) {
  std::string text;
  if (pdo.sync_manager) text += fmt::format(" SM{}", *pdo.sync_manager);
  if (pdo.fixed) text += " fixed";
  if (pdo.mandatory) text += " mandatory";
  return text;
}

void print_pdos(std::ostream& out, std::string_view title, const std::vector<Pdo>& pdos) {
  for (const auto& pdo : pdos) {
    out << fmt::format("{} 0x{:04x} {} ({} bits{})\n", title, pdo.index, pdo.name, pdo.bit_length(), flags_of(pdo));
    for (const auto& entry : pdo.entries) {
      if (entry.index == 0) continue;
      out << fmt::format("    0x{:04x}:{:02x} {:<6} {}\n", entry.index, entry.sub_index, entry.data_type, entry.name);
    }
  }
}

void print_device(std::ostream& out, const Json& json, const eni::CatalogueEntry& entry,
                  const DeviceDescription& device) {
  out << entry_line(entry) << '\n'
      << fmt::format("vendor   {}\ngroup    {}\nfile     {}:{}\n", entry.vendor_name,
                     entry.group_name.empty() ? entry.group_type : entry.group_name, entry.file, entry.line);
  std::string protocols;
  for (const auto& protocol : json["mailbox"])
    protocols += (protocols.empty() ? "" : " ") + protocol.get<std::string>();
  out << fmt::format("mailbox  {}\nsync     {} SyncManagers, {} FMMUs, {} objects, {} modules\n",
                     protocols.empty() ? "none" : protocols, device.sync_managers.size(), device.fmmus.size(),
                     device.dictionary.size(), device.modules.size());
  for (const auto& mode : json["op_modes"]) {
    out << fmt::format("op mode  {} ({}) {}\n", mode["name"].get<std::string>(),
                       mode["assign_activate"].get<std::string>(), mode["description"].get<std::string>());
  }
  print_pdos(out, "RxPDO", device.rx_pdos);
  print_pdos(out, "TxPDO", device.tx_pdos);
}

void show(Context& context, const ShowOptions& options) {
  const auto catalogue = open_catalogue(context, options.esi);
  if (!catalogue) return context.fail_with(catalogue.error());
  const auto entry = find_entry(*catalogue, options.device);
  if (!entry) return context.fail_with(entry.error());
  const auto device = catalogue->device(*entry);
  if (!device) return context.fail_with(device.error());
  const auto json = device_json(*entry, **device);
  if (options.json) return context.print(json);
  print_device(context.console.out, json, *entry, **device);
}

}  // namespace

void add_esi_show(CLI::App& esi, Context& context) {
  auto* command = esi.add_subcommand("show", "Show what an ESI file says about a device");
  auto options = std::make_shared<ShowOptions>();
  command->add_option("device", options->device, "VENDOR:PRODUCT[:REVISION] or a type")->required();
  add_esi_folders(*command, options->esi);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { show(context, *options); });
}

}  // namespace syncline::cli
