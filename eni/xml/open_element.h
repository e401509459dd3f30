// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace syncline::eni {

/// The innermost element that is open where `text` stops being XML: at the first markup that does not end or has no
/// name, else at its end. A view of `text`; empty outside of every element. For messages: that end tags match is not
/// looked at.
[[nodiscard]] std::string_view open_element(std::string_view text);

}  // namespace syncline::eni
