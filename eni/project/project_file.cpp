// SPDX-License-Identifier: Apache-2.0
#include "eni/project/project_file.h"

#include <algorithm>
#include <map>
#include <span>

#include "config/device_description.h"
#include "config/project.h"
#include "eni/format/eni_reader.h"
#include "eni/project/project_fields.h"
#include "eni/project/view_fields.h"
#include "eni/xml/xml_pieces.h"
#include "eni/xml/xml_text.h"
#include "reasons/because.h"
#include "settings/sync_settings.h"

namespace syncline::eni {
namespace {

constexpr const char* kProjectRoot = "SynclineProject";
/// 1: one network in the root. 2: Network elements, only written when there are several, so that older programs go on
/// reading what they understand.
constexpr int kOneNetwork = 1, kSeveralNetworks = 2;

using Devices = std::vector<const DeviceDescription*>;
using ReadDevices = std::map<std::string, DeviceDescription>;

std::size_t device_number(Devices& devices, const DeviceDescription& device) {
  const auto known = std::ranges::find_if(devices, [&](const auto* d) { return *d == device; });
  if (known != devices.end()) return static_cast<std::size_t>(known - devices.begin()) + 1;
  devices.push_back(&device);
  return devices.size();
}

void write_devices(XmlWriter& xml, const Devices& devices) {
  xml.open("Devices");
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const DeviceDescription& device = *devices[i];
    xml.open("DeviceDescription").attribute("Id", std::to_string(i + 1));
    xml.attribute("VendorId", hex_dec(device.identity.vendor_id, 8)).attribute("VendorName", device.vendor_name);
    xml.attribute("Source", device.source);
    if (!device.group_name.empty()) xml.attribute("GroupName", device.group_name);
    write_device(xml, device);
    write_modules(xml, device.modules);
    xml.close();
  }
  xml.close();
}

DeviceDescription read_embedded(const Node& outer) {
  FileWarnings warnings;
  Reading reading(outer.reading().file(), warnings);
  const Node node = outer.with(reading);
  const EsiVendor vendor{node.number<std::uint32_t>("VendorId").value_or(0), node.attribute("VendorName")};
  auto device =
      read_device(node.required("Device"),
                  {.vendor = vendor, .modules = read_modules(node.child("Modules"), nullptr), .written_by_us = true});
  device.source = node.attribute("Source");
  device.group_name = node.attribute("GroupName");
  if (!reading.ok()) outer.reading().fail(*reading.error());
  if (!warnings.empty()) {  // the program wrote this itself: what cannot be read was damaged
    const FileWarning& first = warnings.front();
    outer.reading().fail(ErrorCode::kXmlBadValue, first.line, first.element, first.reason);
  }
  return device;
}

ReadDevices read_devices(const Node& root) {
  ReadDevices devices;
  for (const Node& node : root.child("Devices").children("DeviceDescription")) {
    devices.emplace(node.attribute("Id"), read_embedded(node));
  }
  return devices;
}

Project read_network(const Node& node, const ReadDevices& devices) {
  Project project;
  project.name = node.attribute("Network");
  FieldReader master(node.required("Master"));
  read_fields(master, project.master);
  FieldReader own(node);
  read_views(own, project.views);
  for (const Node& slave_node : node.required("Slaves").children("Slave")) {
    auto& slave = project.slaves.emplace_back();
    const auto id = slave_node.attribute("Device");
    const auto device = devices.find(id);
    // The device first: what its ESI sends stands for what the file does not say.
    if (device != devices.end()) slave.device = device->second;
    FieldReader reader(slave_node);
    read_fields(reader, slave);
    if (device == devices.end()) {
      slave_node.fail(ErrorCode::kXmlBadValue, because("there is no device \"{name}\" in the file", id));
    } else {
      if (const auto status = check_sync_settings(slave); !status) {
        const auto& key = status.error().subject;
        const char* element = key.starts_with("can.") ? "Can" : key.starts_with("output_pin.") ? "OutputPins" : "Sync";
        const Node node_of_key = slave_node.child(element);
        (node_of_key ? node_of_key : slave_node)
            .fail(ErrorCode::kXmlBadValue,
                  because("slave.{position}.{key}: {reason}", project.slaves.size() - 1, key, status.error().detail));
      }
    }
  }
  return project;
}

Machine read_content(const Node& root) {
  Machine machine;
  machine.name = root.attribute("Machine");
  const auto devices = read_devices(root);
  for (const Node& network : root.children("Network")) machine.networks.push_back(read_network(network, devices));
  if (machine.networks.empty()) machine.networks.push_back(read_network(root, devices));
  return machine;
}

void write_network(XmlWriter& xml, const Project& project, Devices& devices) {
  FieldWriter fields(xml);
  if (!project.name.empty()) xml.attribute("Network", project.name);
  xml.open("Master");
  write_fields(fields, project.master);
  xml.close().open("Slaves");
  for (const auto& slave : project.slaves) {
    xml.open("Slave").attribute("Device", std::to_string(device_number(devices, slave.device)));
    write_fields(fields, slave);
    xml.close();
  }
  xml.close();
  write_views(fields, project.views);
}

std::string write(std::string_view machine_name, std::span<const Project> networks) {
  XmlWriter xml;
  Devices devices;
  const bool several = networks.size() != 1;
  xml.open(kProjectRoot).attribute("Version", std::to_string(several ? kSeveralNetworks : kOneNetwork));
  if (!machine_name.empty()) xml.attribute("Machine", machine_name);
  for (const Project& network : networks) {
    if (several) xml.open("Network");
    write_network(xml, network, devices);
    if (several) xml.close();
  }
  write_devices(xml, devices);
  return xml.take();
}

std::string network_list(const Machine& machine) {
  std::string list;
  for (std::size_t i = 0; i < machine.networks.size(); ++i) {
    const Project& network = machine.networks[i];
    list += fmt::format("{}{} \"{}\"", list.empty() ? "" : ", ", i,
                        network.name.empty() ? network.master.name : network.name);
  }
  return list;
}

Result<Project> take_network(Result<Machine> machine, std::string_view network) {
  if (!machine) return tl::unexpected(machine.error());
  const auto index = find_network(*machine, network);
  if (!index) return tl::unexpected(index.error());
  return std::move(machine->networks[*index]);
}

}  // namespace

std::string write_machine(const Machine& machine) { return write(machine.name, machine.networks); }

std::string write_project(const Project& project) { return write({}, std::span(&project, 1)); }

Result<Machine> parse_machine(std::string_view text, const std::string& file_name) {
  // An ENI, which is told apart from a project by its root, may be large.
  const auto pieces = XmlPieces::parse(text, file_name, is_eni_piece);
  if (!pieces) return tl::unexpected(pieces.error());
  Reading reading(file_name);
  const Node root(pieces->root(), reading);
  const auto other_kind = [&](Reason detail) {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile,
                      .subject = std::string(root.name()),
                      .detail = std::move(detail),
                      .file = file_name,
                      .line = root.line()});
  };
  if (root.name() != kProjectRoot)
    return other_kind(because("a project file with the root <{wanted}>, not <{root}>", kProjectRoot, root.name()));
  if (root.number<int>("Version").value_or(kOneNetwork) > kSeveralNetworks) {
    return other_kind(because("a project file of version {version} or older, not {other}", kSeveralNetworks,
                              root.attribute("Version")));
  }
  auto machine = read_content(root);
  if (!reading.ok()) return tl::unexpected(*reading.error());
  return machine;
}

Result<std::size_t> find_network(const Machine& machine, std::string_view network) {
  const auto& networks = machine.networks;
  if (network.empty() && networks.size() == 1) return std::size_t{0};
  for (std::size_t i = 0; i < networks.size(); ++i) {
    if (!network.empty() && (networks[i].name == network || std::to_string(i) == network)) return i;
  }
  if (network.empty()) {
    return fail(ErrorCode::kBadValue, "--network",
                because("the file holds {count} networks; choose one by number or name: {names}", networks.size(),
                        network_list(machine)));
  }
  return fail(ErrorCode::kBadValue, fmt::format("--network {}", network),
              because("the file holds {names}", network_list(machine)));
}

Result<Project> parse_project(std::string_view text, const std::string& file_name, std::string_view network) {
  return take_network(parse_machine(text, file_name), network);
}

Status save_machine(const Machine& machine, const std::string& path) {
  return write_file_atomic(path, write_machine(machine));
}

Status save_project(const Project& project, const std::string& path) {
  return write_file_atomic(path, write_project(project));
}

Result<Machine> load_machine(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  return parse_machine(*text, path);
}

Result<Project> load_project(const std::string& path, std::string_view network) {
  return take_network(load_machine(path), network);
}

}  // namespace syncline::eni
