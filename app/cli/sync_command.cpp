// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/cli/options.h"
#include "app/cli/visit_options.h"
#include "config/identity.h"
#include "families/device_family.h"
#include "master/mailbox/family_status_reader.h"
#include "master/mailbox/sync_object_reader.h"
#include "master/startup/slave_visit.h"

namespace syncline::cli {
namespace {

struct SyncOptions {
  SlaveOnLink slave;
  bool json = false;
};

std::string_view source_key(CounterSource source) {
  switch (source) {
    case CounterSource::kObjectName:
      return "object_name";
    case CounterSource::kDeviceProfile:
      return "device_profile";
    case CounterSource::kUnknown:
      break;
  }
  return "unknown";
}

std::string_view source_text(CounterSource source) {
  switch (source) {
    case CounterSource::kObjectName:
      return "the slave names its counters";
    case CounterSource::kDeviceProfile:
      return "the slave does not name its counters; what they count is known of this device";
    case CounterSource::kUnknown:
      break;
  }
  return "the slave does not name its counters and is not known; the one that rises when a frame is lost counts missed "
         "events";
}

std::string value_text(const SyncParameters::Entry& entry) {
  switch (entry.meaning) {
    case SyncValue::kType:
      return fmt::format("{}  ({})", entry.value, sync_type_text(entry.value));
    case SyncValue::kSupportedTypes:
      return fmt::format("0x{:04X}  ({})", entry.value, supported_types_text(entry.value));
    default:
      return fmt::format("{}{}", entry.value, is_sync_time(entry.meaning) ? " ns" : "");
  }
}

void print_text(Context& context, const SlaveVisit& visit, const std::vector<SyncParameters>& objects,
                const FamilyStatus& family) {
  auto& out = context.console.out;
  out << fmt::format("{}, {}\n", visit.name(), al_state_name(visit.found()));
  for (const auto& object : objects) {
    out << fmt::format("0x{:04X}     {}\n", object.index, object.name);
    for (const auto& entry : object.entries) {
      out << fmt::format("       :{:02X} {:<32} {}\n", entry.sub_index, entry.name, value_text(entry));
    }
    const bool counters = object.value(SyncValue::kMissed) || object.value(SyncValue::kCycleExceeded) ||
                          object.value(SyncValue::kMissedOrExceeded);
    if (counters) out << fmt::format("       {}\n", source_text(object.counter_source));
  }
  if (objects.empty()) out << "it has no synchronisation objects (0x1C32, 0x1C33)\n";
  if (family.status) {
    const auto& object = *family.family->status;
    out << fmt::format("0x{:04X}     {} 0x{:04X}\n", object.object.index, object.name, *family.status);
    for (const auto& line : family.lines) {
      if (!line.text.empty()) out << fmt::format("       .{}  {}{}\n", line.bit, line.as_wanted ? "" : "! ", line.text);
    }
  }
  for (std::size_t i = 0; i < family.node_states.size(); ++i) {
    const bool late = family.node_states[i] == family.family->gateway->node_late;
    out << fmt::format("0x{:04X}:{:02X}  state of CAN node {} is 0x{:02X}{}\n", family.family->gateway->node_states,
                       i + 1, i + 1, family.node_states[i],
                       late ? ": its synchronous TxPDO was not there in time" : "");
  }
}

Json family_json(const FamilyStatus& family) {
  if (family.family == nullptr) return nullptr;
  Json bits = Json::array();
  for (const auto& line : family.lines) {
    bits.push_back({{"bit", line.bit}, {"as_wanted", line.as_wanted}, {"text", line.text}});
  }
  return {{"id", family.family->id},
          {"name", family.family->name},
          {"status", family.status ? Json(hex(*family.status, 4)) : Json(nullptr)},
          {"bits", bits},
          {"node_states", family.node_states}};
}

void print_json(Context& context, const SyncOptions& options, const SlaveVisit& visit,
                const std::vector<SyncParameters>& objects, const FamilyStatus& family) {
  Json list = Json::array();
  for (const auto& object : objects) {
    Json entries = Json::array();
    for (const auto& entry : object.entries) {
      entries.push_back({{"sub_index", entry.sub_index},
                         {"meaning", sync_value_key(entry.meaning)},
                         {"name", entry.name},
                         {"value", entry.value}});
    }
    list.push_back({{"index", hex(object.index, 4)},
                    {"name", object.name},
                    {"counter_source", source_key(object.counter_source)},
                    {"entries", entries}});
  }
  context.print({{"position", options.slave.position},
                 {"state", al_state_name(visit.found())},
                 {"objects", list},
                 {"family", family_json(family)}});
}

void show(Context& context, const SyncOptions& options) {
  with_mailbox(context, options.slave, [&](SlaveVisit& visit) -> Status {
    const auto objects = read_sync_objects(visit.mailbox());
    if (!objects) return tl::unexpected(objects.error());
    const auto identity = read_identity_object(visit.mailbox());
    if (!identity) return tl::unexpected(identity.error());
    const auto family = read_family_status(visit.mailbox(), *identity);
    if (!family) return tl::unexpected(family.error());
    if (options.json) {
      print_json(context, options, visit, *objects, *family);
    } else {
      print_text(context, visit, *objects, *family);
    }
    return {};
  });
}

}  // namespace

void add_sync_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<SyncOptions>();
  auto* command =
      app.add_subcommand("sync", "Show how a slave is synchronised, and what it has missed (0x1C32, 0x1C33)");
  add_slave_options(*command, options->slave, options->json);
  command->callback([&context, options] { show(context, *options); });
}

}  // namespace syncline::cli
