// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "config/device_description.h"

namespace syncline::eni {

/// A device as an ESI file may write it: only what a test says.
struct EsiText {
  std::uint32_t product = 1, revision = 0x10;
  std::string type = "T1", name = "Thing", group = "Digital", extra{}, type_attributes{};
};

inline std::string esi_text(const std::vector<EsiText>& devices, const std::string& vendor = "Maker & Sons",
                            std::uint32_t vendor_id = 0x5EC) {
  std::string escaped = vendor;
  if (const auto at = escaped.find('&'); at != std::string::npos) escaped.replace(at, 1, "&amp;");
  std::string text =
      "<EtherCATInfo><Vendor><Id>" + std::to_string(vendor_id) + "</Id><Name>" + escaped +
      "</Name></Vendor><Descriptions>\n<Groups><Group><Type>Digital</Type><Name LcId=\"1031\">Klemmen</Name>"
      "<Name LcId=\"1033\">Digital terminals</Name></Group></Groups><Devices>\n";
  for (const auto& d : devices) {
    text += "<Device Physics=\"YY\"><Type ProductCode=\"" + std::to_string(d.product) + "\" RevisionNo=\"" +
            std::to_string(d.revision) + "\" " + d.type_attributes + ">" + d.type + "</Type>" + d.extra + "<Name>" +
            d.name + "</Name><GroupType>" + d.group + "</GroupType></Device>\n";
  }
  return text + "</Devices></Descriptions></EtherCATInfo>\n";
}

/// A folder of ESI files and a place for a database, both gone afterwards.
class EsiFolderTest : public ::testing::Test {
 protected:
  EsiFolderTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "syncline-catalogue-XXXXXX").string();
    base_ = std::filesystem::canonical(::mkdtemp(pattern.data()));
    std::filesystem::create_directory(folder());
  }
  ~EsiFolderTest() override { std::filesystem::remove_all(base_); }

  [[nodiscard]] std::filesystem::path folder() const { return base_ / "esi"; }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder() / name).string(); }
  [[nodiscard]] std::string database() const { return (base_ / "cache" / "catalogue.db").string(); }

  /// Last changed `age` seconds ago: the catalogue looks twice into files that were written just now.
  void put(const std::string& name, const std::string& text, int age = 60) const {
    std::filesystem::create_directories(std::filesystem::path(file(name)).parent_path());
    std::ofstream(file(name), std::ios::binary) << text;
    std::filesystem::last_write_time(file(name),
                                     std::filesystem::file_time_type::clock::now() - std::chrono::seconds(age));
  }

 private:
  std::filesystem::path base_;
};

}  // namespace syncline::eni
