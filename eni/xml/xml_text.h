// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "support/result.h"

namespace syncline::eni {

/// Bytes of a file. kFileNotFound, kFileNotReadable (a folder, no permission), kFileLimit (beyond kMaxFileBytes).
[[nodiscard]] Result<std::string> read_file(const std::string& path);

/// Writes a temporary file beside `path`, syncs it to the disk and renames it over `path`: a reader sees the old or the
/// new content, never half of it. What a killed program left beside it goes at the next save. kFileNotWritable with the
/// system's reason; `path` is then unchanged.
[[nodiscard]] Status write_file_atomic(const std::string& path, std::string_view content);

/// Valid UTF-8 for a text that goes into a file: what is none is taken for ISO-8859-1. Files of others:
/// text_encoding.h.
[[nodiscard]] std::string to_utf8(std::string text);

/// Valid UTF-8 without control characters: for strings out of a slave's EEPROM, which XML may not be able to carry.
[[nodiscard]] std::string printable_text(std::string text);

[[nodiscard]] inline std::uint8_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<std::uint8_t>(text[i]);
}

[[nodiscard]] std::string_view trim(std::string_view text);

}  // namespace syncline::eni
