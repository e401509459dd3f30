// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace syncline::eni {

inline bool have_xmllint() { return std::system("xmllint --version >/dev/null 2>&1") == 0; }

/// Validates with xmllint; what it says is in the failure.
inline void expect_valid(const std::string& text, const std::string& schema) {
  const auto file = std::filesystem::temp_directory_path() / ("syncline-eni-" + std::to_string(::getpid()) + ".xml");
  std::ofstream(file, std::ios::binary) << text;
  const std::string command = "xmllint --noout --nonet --schema '" + schema + "' '" + file.string() + "' 2>&1";
  FILE* pipe = ::popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string said;
  for (int c; (c = std::fgetc(pipe)) != EOF;) said += static_cast<char>(c);
  EXPECT_EQ(::pclose(pipe), 0) << said;
  std::filesystem::remove(file);
}

}  // namespace syncline::eni
