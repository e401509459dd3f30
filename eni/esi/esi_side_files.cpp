// SPDX-License-Identifier: Apache-2.0
#include "eni/esi/esi_side_files.h"

#include <algorithm>

#include "eni/xml/xml_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

/// ESI files come from Windows.
std::string portable_name(std::string name) {
  std::ranges::replace(name, '\\', '/');
  return std::filesystem::path(std::string(trim(name))).lexically_normal().string();
}

bool leaves_folder(const std::filesystem::path& relative) {
  return relative.empty() || relative.is_absolute() || *relative.begin() == "..";
}

}  // namespace

SideFile::SideFile(XmlDocument document, Reading reading)
    : document_(std::move(document)), reading_(std::move(reading)) {}

Node SideFile::root() { return {document_->RootElement(), reading_}; }

SideFiles::SideFiles(std::filesystem::path folder, const Reading& reading)
    : folder_(std::move(folder)), like_(reading.of_part()) {}

Result<SideFile*> SideFiles::open(const std::string& name) {
  const auto relative = portable_name(name);
  if (const auto known = files_.find(relative); known != files_.end()) return known->second.get();
  const auto path = (folder_ / relative).string();
  if (leaves_folder(relative)) {
    return fail(ErrorCode::kNotSupported, name, because("it lies outside of the folder of the ESI file"));
  }
  if (files_.size() >= kMost)
    return fail(ErrorCode::kNotSupported, name, because("the ESI file refers to too many files"));
  auto document = load_xml(path);
  if (!document) return tl::unexpected(document.error());
  auto file = std::make_unique<SideFile>(std::move(*document), like_.of_file(path));
  return files_.emplace(relative, std::move(file)).first->second.get();
}

bool SideFiles::visit(const std::string& name) { return visited_.insert(portable_name(name)).second; }

}  // namespace syncline::eni
