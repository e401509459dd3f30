// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/cli/context.h"
#include "app/cli/options.h"
#include "app/cli/terminal_reason.h"
#include "app/cli/visit_options.h"
#include "master/mailbox/coe_client.h"
#include "master/mailbox/object_dictionary_reader.h"
#include "master/startup/slave_visit.h"
#include "protocol/coe.h"
#include "protocol/object_value.h"

namespace syncline::cli {
namespace {

struct SdoOptions {
  SlaveOnLink slave;
  std::string object, value, type;
  bool complete = false, json = false;
};

std::string access_text(std::uint16_t access) {
  std::string text;
  text += (access & coe::access::kRead) != 0 ? 'r' : '-';
  text += (access & coe::access::kWrite) != 0 ? 'w' : '-';
  text += (access & coe::access::kRxPdo) != 0 ? 'R' : '-';
  text += (access & coe::access::kTxPdo) != 0 ? 'T' : '-';
  return text;
}

Json entry_json(const coe::EntryDescription& entry) {
  return {{"sub_index", entry.sub_index},
          {"type", data_type_name(entry.data_type)},
          {"bits", entry.bit_length},
          {"access", access_text(entry.access)},
          {"name", entry.name}};
}

void print_dictionary(Context& context, const SdoOptions& options, const std::vector<DictionaryObject>& objects) {
  if (options.json) {
    Json list = Json::array();
    for (const auto& object : objects) {
      Json entries = Json::array();
      for (const auto& entry : object.entries) entries.push_back(entry_json(entry));
      list.push_back({{"index", hex(object.object.index, 4)}, {"name", object.object.name}, {"entries", entries}});
    }
    return context.print({{"position", options.slave.position}, {"objects", list}});
  }
  for (const auto& object : objects) {
    context.console.out << fmt::format("0x{:04X}     {}\n", object.object.index,
                                       object.error ? "(not described)" : object.object.name);
    for (const auto& entry : object.entries) {
      context.console.out << fmt::format("       :{:02X} {:<8} {:>4} bit {}  {}\n", entry.sub_index,
                                         data_type_name(entry.data_type), entry.bit_length, access_text(entry.access),
                                         entry.name);
    }
  }
}

Status list_objects(Context& context, const SdoOptions& options, SlaveVisit& visit) {
  ObjectDictionaryReader reader(visit.mailbox());
  const auto objects = reader.read();
  if (!objects) return tl::unexpected(objects.error());
  print_dictionary(context, options, *objects);
  return {};
}

/// As the user says, else as the device says, else bytes. Not every slave describes its objects.
Result<std::uint16_t> type_of(const SdoOptions& options, coe::ObjectAddress object, SlaveVisit& visit) {
  if (!options.type.empty()) return data_type_code(options.type);
  if (options.complete) return kBytesType;
  const auto entry = SdoInfoClient(visit.mailbox()).entry(object.index, object.sub_index);
  if (entry) return entry->data_type;
  const auto code = entry.error().code;
  const bool not_told =
      code == ErrorCode::kSdoAbort || code == ErrorCode::kMailboxProtocol || code == ErrorCode::kMailboxTimeout;
  if (!not_told) return tl::unexpected(entry.error());
  return kBytesType;
}

void print_value(Context& context, const SdoOptions& options, coe::ObjectAddress object, std::uint16_t type,
                 std::span<const std::uint8_t> bytes, bool written) {
  const auto text = value_text(type, bytes);
  if (options.json) {
    return context.print({{"position", options.slave.position},
                          {"index", hex(object.index, 4)},
                          {"sub_index", object.sub_index},
                          {"complete", options.complete},
                          {"type", data_type_name(type)},
                          {"value", text},
                          {"bytes", value_text(kBytesType, bytes)},
                          {"written", written}});
  }
  context.console.out << fmt::format("0x{:04X}:{:02X}{} {} {}{}\n", object.index, object.sub_index,
                                     options.complete ? " (complete)" : "", data_type_name(type), text,
                                     written ? " written" : "");
}

Status read_object(Context& context, const SdoOptions& options, coe::ObjectAddress object, SlaveVisit& visit) {
  const auto type = type_of(options, object, visit);
  if (!type) return tl::unexpected(type.error());
  const auto bytes = CoeClient(visit.mailbox()).upload(object, options.complete);
  if (!bytes) return tl::unexpected(bytes.error());
  print_value(context, options, object, *type, *bytes, false);
  return {};
}

Status write_object(Context& context, const SdoOptions& options, coe::ObjectAddress object, SlaveVisit& visit) {
  const auto type = type_of(options, object, visit);
  if (!type) return tl::unexpected(type.error());
  const auto bytes = value_bytes(*type, options.value);
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto status = CoeClient(visit.mailbox()).download(object, *bytes, options.complete); !status) return status;
  print_value(context, options, object, *type, *bytes, true);
  return {};
}

using ObjectWork = Status (*)(Context&, const SdoOptions&, coe::ObjectAddress, SlaveVisit&);

/// What the user typed is checked before the slave is touched.
void with_object(Context& context, const SdoOptions& options, ObjectWork work) {
  const auto name = object_name(options.object);
  if (!name) return context.fail_with(name.error());
  if (options.complete && name->sub_index > 1) {
    return context.fail_with(
        {ErrorCode::kBadValue, "INDEX", in_terminal("complete access begins at sub-index 0 or 1")});
  }
  if (!options.type.empty()) {
    if (const auto type = data_type_code(options.type); !type) return context.fail_with(type.error());
  }
  with_mailbox(context, options.slave, [&](SlaveVisit& visit) {
    return work(context, options, {name->index, name->sub_index}, visit);
  });
}

CLI::App* add(CLI::App& sdo, const std::shared_ptr<SdoOptions>& options, const char* name, const char* description) {
  auto* command = sdo.add_subcommand(name, description);
  add_slave_options(*command, options->slave, options->json);
  return command;
}

void add_object_options(CLI::App& command, SdoOptions& options) {
  command.add_option("object", options.object, "INDEX[:SUB] in hexadecimal, 0x1018:01")->required();
  command.add_flag("--complete", options.complete, "Complete access: the whole object from this sub-index (0 or 1) on");
  command.add_option("--type", options.type,
                     "Data type instead of the one that the slave tells: UINT, REAL, STRING, BYTES ...");
}

}  // namespace

void add_sdo_command(CLI::App& app, Context& context) {
  auto* sdo = app.add_subcommand("sdo", "List, read or write the CoE objects of a slave");
  sdo->require_subcommand(1);

  auto listing = std::make_shared<SdoOptions>();
  add(*sdo, listing, "list", "All objects and entries in the slave's own words (SDO information)")
      ->callback([&context, listing] {
        with_mailbox(context, listing->slave,
                     [&](SlaveVisit& visit) { return list_objects(context, *listing, visit); });
      });

  auto reading = std::make_shared<SdoOptions>();
  auto* read = add(*sdo, reading, "read", "Read an object");
  add_object_options(*read, *reading);
  read->callback([&context, reading] { with_object(context, *reading, read_object); });

  auto writing = std::make_shared<SdoOptions>();
  auto* write = add(*sdo, writing, "write", "Write an object");
  add_object_options(*write, *writing);
  write->add_option("value", writing->value, "Number, text, or bytes in hexadecimal, as the type asks for")->required();
  write->callback([&context, writing] { with_object(context, *writing, write_object); });
}

}  // namespace syncline::cli
