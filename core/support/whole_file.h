// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "support/result.h"

namespace syncline {

inline constexpr std::size_t kLargestWholeFile = 128U << 20;

/// Bytes of a file, or of a pipe until its end. kFileNotFound, kFileNotReadable (a folder, no permission), kFileLimit
/// (beyond `largest` bytes), kCancelled (a signal ended the waiting for a pipe, see InputFile).
[[nodiscard]] Result<std::string> read_whole_file(const std::string& path, std::size_t largest = kLargestWholeFile);

/// Complete or not at all, see OutputFile. kFileNotWritable, kCancelled; what was there is then unchanged.
[[nodiscard]] Status write_whole_file(const std::string& path, std::string_view content);
[[nodiscard]] Status write_whole_file(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace syncline
