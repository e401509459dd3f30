// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace syncline::coe {

/// All that abort_code_text() (protocol/coe.h) can say, for translations.
[[nodiscard]] std::vector<std::string_view> abort_code_texts();

}  // namespace syncline::coe
