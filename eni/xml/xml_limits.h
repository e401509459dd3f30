// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "support/result.h"

/// What is looked at before a parser sees a text that others wrote: a parser takes much more memory than the text has,
/// and some texts are made to take all of it. The limits are far beyond what tools write.
namespace syncline::eni {

inline constexpr std::size_t kMaxFileBytes = 128U << 20;  // the largest ESI files known have some 15 MB
inline constexpr std::size_t kMaxElements = 4'000'000;    // about 120 bytes of memory each
inline constexpr std::size_t kMaxAttributes = 4'000'000;
inline constexpr std::size_t kMaxAttributesOfElement = 1'000;  // the parser compares each with all others
/// Elements, attributes and comments of a file that has many: each takes about 120 bytes of memory. Files of tools have
/// 15 bytes for each and more, even where nothing stands between their tags.
inline constexpr std::size_t kManyParts = 100'000;
inline constexpr std::size_t kLeastBytesOfPart = 10;
inline constexpr int kMaxDepth = 200;  // ESI and ENI need about fifteen levels

/// kFileLimit with file and line: too long, too many or too deeply nested elements, too many attributes, more of all
/// than its length is worth, or entities of its own, which may grow without bound and are not read. A text that is no
/// XML passes: the parser says what is wrong.
[[nodiscard]] Status check_xml_limits(std::string_view text, const std::string& file_name);

}  // namespace syncline::eni
