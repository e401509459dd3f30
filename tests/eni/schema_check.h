// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/sample_folder.h"

namespace syncline::eni {

inline bool have_xmllint() { return std::system("xmllint --version >/dev/null 2>&1") == 0; }

/// Ours of what we write, and the published one of what may be written where it is here.
struct Schema {
  bool own = true;
  std::string path;
};
inline std::vector<Schema> eni_schemas() {
  std::vector<Schema> schemas{{true, (test::own_samples("schema") / "eni_as_written.xsd").string()}};
  if (const auto published = test::sample_file("schema/EtherCATConfig.xsd")) schemas.push_back({false, *published});
  return schemas;
}
inline void PrintTo(const Schema& schema, std::ostream* out) { *out << schema.path; }
struct SchemaName {
  template <class Info>
  std::string operator()(const Info& info) const {
    return info.param.own ? "Ours" : "Published";
  }
};

/// What xmllint says against it; empty: it is valid.
inline std::string schema_says(const std::string& text, const std::string& schema) {
  const auto file = std::filesystem::temp_directory_path() / ("syncline-eni-" + std::to_string(::getpid()) + ".xml");
  std::ofstream(file, std::ios::binary) << text;
  const std::string command = "xmllint --noout --nonet --schema '" + schema + "' '" + file.string() + "' 2>&1";
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return "xmllint does not start";
  std::string said;
  for (int c; (c = std::fgetc(pipe)) != EOF;) said += static_cast<char>(c);
  const bool valid = ::pclose(pipe) == 0;
  std::filesystem::remove(file);
  return valid ? "" : said;
}

inline void expect_valid(const std::string& text, const std::string& schema) {
  EXPECT_EQ(schema_says(text, schema), "");
}

}  // namespace syncline::eni
