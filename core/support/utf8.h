// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace syncline {

/// True for valid UTF-8: no overlong forms, no surrogates, nothing beyond U+10FFFF.
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace syncline
