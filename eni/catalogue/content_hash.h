// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <cstdint>
#include <string_view>

/// 64-bit fingerprints that tell whether a file or an element is still the same. Not against somebody who forges one.
namespace syncline::eni {

[[nodiscard]] std::uint64_t content_hash(std::string_view bytes);
/// Of elements, attributes and texts in their order; white space around texts, comments and the spelling of
/// entities do not count.
[[nodiscard]] std::uint64_t content_hash(const tinyxml2::XMLElement& element);

}  // namespace syncline::eni
