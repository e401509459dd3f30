// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "support/result.h"

namespace syncline {

/// kFileNotFound, kFileNotReadable.
[[nodiscard]] Result<std::vector<std::uint8_t>> read_whole_file(const std::string& path);
/// Complete or not at all: a file that is there under its name is whole. kFileNotWritable.
[[nodiscard]] Status write_whole_file(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace syncline
