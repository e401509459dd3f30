// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "tests/support/source_dir.h"

/// Files of other tools and vendors, kept outside the source tree: $SYNCLINE_SAMPLES, or ../shared/samples beside it.
namespace syncline::test {

inline std::optional<std::filesystem::path> sample_folder() {
  const char* chosen = std::getenv("SYNCLINE_SAMPLES");
  const std::filesystem::path folder =
      chosen ? std::filesystem::path(chosen) : std::filesystem::path(test::source_dir()) / "../shared/samples";
  return std::filesystem::is_directory(folder) ? std::optional(folder) : std::nullopt;
}

/// Path of a sample file, nothing when it is not there.
inline std::optional<std::string> sample_file(const std::string& relative) {
  const auto folder = sample_folder();
  if (!folder || !std::filesystem::exists(*folder / relative)) {
    return std::nullopt;
  }
  return (*folder / relative).string();
}

}  // namespace syncline::test

/// Declares `name` as the path of a sample, or skips the test.
#define SYNCLINE_SAMPLE(name, relative)                                                 \
  const auto name##_found = ::syncline::test::sample_file(relative);                    \
  if (!name##_found) GTEST_SKIP() << "sample not here: " << (relative);                 \
  const std::string name = *name##_found
