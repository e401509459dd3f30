// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace syncline::eni {

/// UTF-8 as it is; anything else is taken for ISO-8859-1, which the field's tools declare and write.
[[nodiscard]] std::string to_utf8(std::string_view text);

/// Length of the UTF-8 sequence at the start of `text` (not empty), 0 when there is none.
[[nodiscard]] std::size_t utf8_sequence_length(std::string_view text);

}  // namespace syncline::eni
