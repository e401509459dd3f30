// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "eni/xml/xml_reader.h"
#include "support/result.h"

namespace syncline::eni {

/// A file that an ESI refers to, parsed.
class SideFile {
 public:
  SideFile(XmlDocument document, Reading reading);
  [[nodiscard]] Node root();
  [[nodiscard]] Reading& reading() { return reading_; }

 private:
  XmlDocument document_;
  Reading reading_;
};

/// Files beside one ESI file: DictionaryFile (EtherCATDict) and InfoReference (EtherCATModule, EtherCATInfo). Each is
/// read once, so that files that refer to each other end.
class SideFiles {
 public:
  static constexpr std::size_t kMost = 64;  // files of one ESI

  /// `folder` of the ESI file; warnings of the side files go where `reading`'s go.
  SideFiles(std::filesystem::path folder, const Reading& reading);

  /// `name` as the ESI writes it, relative to its folder. kFileNotFound, kXmlMalformed ...; kNotSupported for a place
  /// outside the folder.
  [[nodiscard]] Result<SideFile*> open(const std::string& name);
  /// True the first time.
  [[nodiscard]] bool visit(const std::string& name);

 private:
  std::filesystem::path folder_;
  Reading like_;
  std::map<std::string, std::unique_ptr<SideFile>> files_;
  std::set<std::string> visited_;
};

}  // namespace syncline::eni
