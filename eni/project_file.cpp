// SPDX-License-Identifier: Apache-2.0
#include "eni/project_file.h"

#include <algorithm>
#include <map>

#include "eni/project_fields.h"
#include "eni/xml_text.h"

namespace syncline::eni {
namespace {

constexpr const char* kRoot = "SynclineProject";
constexpr int kVersion = 1;

using Devices = std::vector<const DeviceDescription*>;

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
    write_device(xml, device);
    xml.close();
  }
  xml.close();
}

DeviceDescription read_embedded(const Node& node) {
  FileWarnings warnings;
  const EsiVendor vendor{node.number<std::uint32_t>("VendorId").value_or(0), node.attribute("VendorName")};
  auto device = read_device(node.required("Device"), vendor, warnings);
  device.source = node.attribute("Source");
  if (!warnings.empty()) {  // the program wrote this itself: what cannot be read was damaged
    const FileWarning& first = warnings.front();
    node.reading().fail(ErrorCode::kXmlBadValue, first.line, first.element, first.text);
  }
  return device;
}

std::map<std::string, DeviceDescription> read_devices(const Node& root) {
  std::map<std::string, DeviceDescription> devices;
  for (const Node& node : root.child("Devices").children("DeviceDescription")) {
    devices.emplace(node.attribute("Id"), read_embedded(node));
  }
  return devices;
}

Project read_content(const Node& root) {
  Project project;
  FieldReader master(root.required("Master"));
  read_fields(master, project.master);
  const auto devices = read_devices(root);
  for (const Node& node : root.required("Slaves").children("Slave")) {
    auto& slave = project.slaves.emplace_back();
    FieldReader reader(node);
    read_fields(reader, slave);
    const auto device = devices.find(node.attribute("Device"));
    if (device == devices.end()) {
      node.fail(ErrorCode::kXmlBadValue, fmt::format("there is no device \"{}\" in the file", node.attribute("Device")));
    } else {
      slave.device = device->second;
    }
  }
  return project;
}

}  // namespace

std::string write_project(const Project& project) {
  XmlWriter xml;
  Devices devices;
  xml.open(kRoot).attribute("Version", std::to_string(kVersion));
  FieldWriter fields(xml);
  xml.open("Master");
  write_fields(fields, project.master);
  xml.close().open("Slaves");
  for (const auto& slave : project.slaves) {
    xml.open("Slave").attribute("Device", std::to_string(device_number(devices, slave.device)));
    write_fields(fields, slave);
    xml.close();
  }
  xml.close();
  write_devices(xml, devices);
  return xml.take();
}

Result<Project> parse_project(std::string_view text, const std::string& file_name) {
  const auto document = parse_xml(text, file_name);
  if (!document) return tl::unexpected(document.error());
  Reading reading(file_name);
  const Node root((*document)->RootElement(), reading);
  const auto other_kind = [&](std::string detail) {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile, .subject = std::string(root.name()),
                      .detail = std::move(detail), .file = file_name, .line = root.line()});
  };
  if (root.name() != kRoot) return other_kind(fmt::format("a project file with the root <{}>, not <{}>", kRoot, root.name()));
  if (root.number<int>("Version").value_or(kVersion) > kVersion) {
    return other_kind(fmt::format("a project file of version {} or older, not {}", kVersion, root.attribute("Version")));
  }
  auto project = read_content(root);
  if (!reading.ok()) return tl::unexpected(*reading.error());
  return project;
}

Status save_project(const Project& project, const std::string& path) {
  return write_file_atomic(path, write_project(project));
}

Result<Project> load_project(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  return parse_project(*text, path);
}

}  // namespace syncline::eni
