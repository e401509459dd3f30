// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "support/result.h"

/// The code pages in which makers write their files. Converting is the C library's business (iconv); which page a text
/// is in is decided here.
namespace syncline::eni {

struct TextEncoding {
  std::string name = "UTF-8";  // as iconv knows it
  std::size_t mark = 0;        // bytes of the byte order mark in front
  bool guessed = false;        // the text says nothing, or something that is not true
  bool operator==(const TextEncoding&) const = default;
};

/// By the byte order mark, by the zeros beside "<" (UTF-16 and UTF-32 without mark), by the XML declaration as far as
/// the bytes do not contradict it; else UTF-8, or a guess: GB 18030 where all that is not ASCII comes in pairs of that
/// code, windows-1252 otherwise (what ISO-8859-1 means in the field).
[[nodiscard]] TextEncoding find_encoding(std::string_view text);

/// The text in UTF-8 without mark: a view of `text`, or of `buffer` where something had to be converted.
/// kFileNotReadable names the encoding that this system does not know, or the byte that is none of it.
[[nodiscard]] Result<std::string_view> decode_text(std::string_view text, std::string& buffer,
                                                   const std::string& file_name);

}  // namespace syncline::eni
