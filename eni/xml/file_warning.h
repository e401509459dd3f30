// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reasons/reason.h"

namespace syncline::eni {

/// Something in a file that was tolerated, or left out: where and why.
struct FileWarning {
  std::string file;
  int line = 0;
  std::string element;
  Reason reason{};
  bool operator==(const FileWarning&) const = default;
};
using FileWarnings = std::vector<FileWarning>;

}  // namespace syncline::eni
