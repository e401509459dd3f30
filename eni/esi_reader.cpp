// SPDX-License-Identifier: Apache-2.0
#include "eni/esi_reader.h"

#include <fmt/format.h>

#include "eni/esi_device.h"
#include "eni/xml_reader.h"
#include "eni/xml_text.h"
#include "protocol/error_text.h"

namespace syncline::eni {
namespace {

EsiVendor read_vendor(const Node& info) {
  const Node vendor = info.required("Vendor");
  return {vendor.required("Id").number<std::uint32_t>(), vendor.localized("Name").trimmed()};
}

/// "Device EL2004": what a user finds in the file.
std::string subject_of(const Node& device) {
  const auto type = device.child("Type").trimmed();
  return type.empty() ? "Device" : "Device " + type;
}

void read_devices(const Node& info, EsiFile& file) {
  const EsiVendor vendor = read_vendor(info);
  const Node devices = info.required("Descriptions").child("Devices");
  for (const Node& node : devices.children("Device")) {
    Reading reading(node.reading().file());  // its own: one broken device must not take the others with it
    auto device = read_device(node.with(reading), vendor, file.warnings);
    if (reading.ok()) {
      file.devices.push_back(std::move(device));
    } else {
      const Error& error = *reading.error();
      file.warnings.push_back({error.file, error.line, error.subject,
                               fmt::format("{} is left out: {}", subject_of(node), describe(error))});
    }
  }
}

Result<EsiFile> read_document(const tinyxml2::XMLDocument& document, const std::string& file_name) {
  Reading reading(file_name);
  const Node root(document.RootElement(), reading);
  EsiFile file;
  if (root.name() == "EtherCATInfo") {
    read_devices(root, file);
  } else if (root.name() == "EtherCATInfoList") {
    for (const Node& info : root.children("EtherCATInfo")) read_devices(info, file);
  } else {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile,
                      .subject = std::string(root.name()),
                      .detail = fmt::format("an ESI file with the root <EtherCATInfo>, not <{}>", root.name()),
                      .file = file_name,
                      .line = root.line()});
  }
  if (!reading.ok()) return tl::unexpected(*reading.error());
  return file;
}

}  // namespace

Result<EsiFile> parse_esi(std::string_view text, const std::string& file_name) {
  const auto document = parse_xml(text, file_name);
  if (!document) return tl::unexpected(document.error());
  return read_document(**document, file_name);
}

Result<EsiFile> read_esi(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  return parse_esi(*text, path);
}

}  // namespace syncline::eni
