// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "support/result.h"

namespace syncline::eni {

/// Writes `content` to a temporary file beside `path`, flushes it to the disk and renames it over `path`: a reader sees
/// the old file or the new one, never half of it. kFileNotWritable with the system's reason; `path` is then unchanged.
[[nodiscard]] Status write_file_atomically(const std::string& path, std::string_view content);

/// The whole file. kFileNotFound or kFileNotReadable.
[[nodiscard]] Result<std::string> read_whole_file(const std::string& path);

}  // namespace syncline::eni
