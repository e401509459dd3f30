// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// The sources of the project as text, for the tests that hold its rules. Files are named relative to the project.
namespace syncline::test::house {

/// All sources below `folder`, in order.
[[nodiscard]] std::vector<std::string> sources(const std::string& folder);
/// The folders right below `folder`.
[[nodiscard]] std::vector<std::string> folders_of(const std::string& folder);
[[nodiscard]] std::string text_of(const std::string& file);

struct Include {
  std::string name;
  bool ours = false;  // in quotes
};
[[nodiscard]] std::vector<Include> includes_of(const std::string& file);
/// Where an include of ours lies; empty when it is made by the build.
[[nodiscard]] std::string file_of(const std::string& include);

}  // namespace syncline::test::house
