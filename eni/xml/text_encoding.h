// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reasons/reason.h"
#include "support/result.h"

/// The code pages in which makers write their files. Converting is the C library's business (iconv); which page a text
/// is in is decided here.
namespace syncline::eni {

struct TextEncoding {
  std::string name = "UTF-8";  // as iconv knows it
  std::size_t mark = 0;        // bytes of the byte order mark in front
  bool guessed = false;        // the text says nothing, or something that is not true
  std::string denied{};        // the encoding that the text names and its bytes contradict; "" = UTF-8, or none
  bool operator==(const TextEncoding&) const = default;
};

/// By the byte order mark, by the zeros beside the first character (UTF-16 and UTF-32 without mark: "<" or a space, as
/// XML 1.0, appendix F, has it), by the XML declaration as far as the bytes do not contradict it; else UTF-8, or a
/// guess: GB 18030 where all that is not ASCII comes in pairs of that code, windows-1252 otherwise (what ISO-8859-1
/// means in the field). Bytes contradict windows-1252 where they come in such pairs, and a Chinese or Korean code where
/// more of them stand alone.
[[nodiscard]] TextEncoding find_encoding(std::string_view text);

/// Why letters may come out as others: a guess, or a byte that the encoding does not assign.
struct EncodingDoubt {
  Reason reason;
  int line = 1;
};

struct DecodedText {
  std::string_view text;
  std::optional<EncodingDoubt> doubt{};
};

/// The text in UTF-8 without mark: a view of `text`, or of `buffer` where something had to be converted.
/// kFileNotReadable names the encoding that this system does not know, or the byte that is none of it.
[[nodiscard]] Result<DecodedText> decode_text(std::string_view text, std::string& buffer, const std::string& file_name);

}  // namespace syncline::eni
