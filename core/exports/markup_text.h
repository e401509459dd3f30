// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace syncline::exports {

/// Somebody's text as content or quoted attribute of XML and HTML. Control characters
/// become spaces; bytes that are no UTF-8 become question marks.
[[nodiscard]] std::string markup_text(std::string_view text);

}  // namespace syncline::exports
