// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace syncline::eni {

/// Something in a file that was tolerated: what and where.
struct FileWarning {
  std::string file;
  int line = 0;
  std::string element;
  std::string text;
  bool operator==(const FileWarning&) const = default;
};
using FileWarnings = std::vector<FileWarning>;

}  // namespace syncline::eni
