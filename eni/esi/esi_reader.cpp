// SPDX-License-Identifier: Apache-2.0
#include "eni/esi/esi_reader.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "eni/esi/esi_device.h"
#include "eni/esi/esi_side_files.h"
#include "eni/xml/text_encoding.h"
#include "eni/xml/xml_pieces.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

EsiVendor read_vendor(const Node& info) {
  const Node vendor = info.required("Vendor");
  return {vendor.required("Id").number<std::uint32_t>(), vendor.localized("Name").trimmed()};
}

/// Reads a document and those that it refers to into one EsiFile.
class EsiDocument {
 public:
  EsiDocument(EsiFile& file, XmlPieces& pieces, SideFiles* side_files)
      : file_(file), pieces_(pieces), side_files_(side_files) {}

  void read(const Node& root) {
    if (root.name() == "EtherCATInfo") {
      read_info(root);
    } else if (root.name() == "EtherCATInfoList") {
      for (const Node& info : root.children("EtherCATInfo")) read_info(info);
    } else if (root.name() == "EtherCATModule") {
      read_references(root);
      add_modules(modules_of(root), &pieces_);
    } else {
      root.fail(ErrorCode::kNotThatKindOfFile,
                because("an ESI file with the root <EtherCATInfo>, not <{root}>", root.name()));
    }
  }

 private:
  void read_info(const Node& info) {
    read_references(info);
    const Node descriptions = info.required("Descriptions");
    add_modules(modules_of(descriptions), &pieces_);
    EsiSurroundings surroundings{.vendor = read_vendor(info),
                                 .groups = read_groups(descriptions),
                                 .modules = file_.modules,
                                 .pdo_templates = read_pdo_templates(descriptions),
                                 .side_files = side_files_};
    for (const Node& stub : descriptions.child("Devices").children("Device")) {
      if (const Node node = pieces_.whole(stub)) add_device(node, surroundings);
    }
    std::ranges::move(surroundings.groups, std::back_inserter(file_.groups));
  }

  void add_device(const Node& node, const EsiSurroundings& surroundings) {
    Reading part = node.reading().of_part();  // its own: one broken device must not take the others with it
    auto device = read_device(node.with(part), surroundings);
    if (part.ok()) {
      file_.devices.push_back(std::move(device));
      return;
    }
    Error error = *part.error();
    const auto type = node.child("Type").trimmed();
    auto left_out = type.empty() ? because("Device is left out: {error}", reason_of(error))
                                 : because("Device {device} is left out: {error}", type, reason_of(error));
    part.warn(error.line, error.subject, std::move(left_out));
    error.detail = type.empty() ? because("Device: {reason}", error.detail)
                                : because("Device {device}: {reason}", type, error.detail);
    file_.rejected.push_back(std::move(error));
  }

  /// In older EtherCATModule files the modules stand in the root, otherwise in Modules.
  [[nodiscard]] Node modules_of(const Node& parent) const {
    const Node modules = parent.child("Modules");
    return modules ? modules : parent;
  }

  void add_modules(const Node& modules, XmlPieces* pieces) {
    std::ranges::move(read_modules(modules, side_files_, pieces), std::back_inserter(file_.modules));
  }

  /// InfoReference: the modules of other files; a file that was visited is not visited again.
  void read_references(const Node& info) {
    for (const Node& reference : info.children("InfoReference")) {
      const auto name = reference.trimmed();
      if (name.empty()) continue;
      if (side_files_ == nullptr) {
        reference.warn(because("\"{name}\" is another file, which is not read here", name));
      } else if (side_files_->visit(name)) {
        read_reference(reference, name);
      }
    }
  }

  void read_reference(const Node& reference, const std::string& name) {
    const auto file = side_files_->open(name);
    if (!file) {
      reference.warn(because("the file is left out: {error}", reason_of(file.error())));
      return;
    }
    const Node root = (*file)->root();
    read_references(root);
    add_modules(modules_of(root.child("Descriptions") ? root.child("Descriptions") : root), nullptr);
  }

  EsiFile& file_;
  XmlPieces& pieces_;
  SideFiles* side_files_;
};

Result<EsiFile> read_text(std::string_view text, const std::string& file_name, const EsiReadOptions& options,
                          const std::filesystem::path* folder) {
  auto pieces = XmlPieces::parse(text, file_name, is_esi_piece);
  if (!pieces) return tl::unexpected(pieces.error());
  EsiFile file;
  Reading reading(file_name, file.warnings, options.language);
  if (const auto& doubt = pieces->doubt()) reading.warn(doubt->line, "?xml", doubt->reason);
  std::optional<SideFiles> side_files;
  if (folder != nullptr) {
    side_files.emplace(*folder, reading);
    (void)side_files->visit(std::filesystem::path(file_name).filename().string());
  }
  EsiDocument(file, *pieces, side_files ? &*side_files : nullptr).read({pieces->root(), reading});
  if (pieces->error()) return tl::unexpected(*pieces->error());
  if (!reading.ok()) return tl::unexpected(*reading.error());
  return file;
}

}  // namespace

bool is_esi_piece(std::string_view element, std::string_view parent) {
  // Modules stand in Modules, in older files right in what is around it.
  return (element == "Device" && parent == "Devices") ||
         (element == "Module" && (parent == "Modules" || parent == "Descriptions" || parent == "EtherCATModule"));
}

Result<EsiFile> parse_esi(std::string_view text, const std::string& file_name, const EsiReadOptions& options) {
  return read_text(text, file_name, options, nullptr);
}

Result<EsiFile> read_esi(const std::string& path, const EsiReadOptions& options) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  const auto folder = std::filesystem::path(path).parent_path();
  return read_text(*text, path, options, &folder);
}

}  // namespace syncline::eni
