// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// Reasons about who stands where on the bus; see reason_words.h.
namespace syncline::words {

inline constexpr std::string_view kSurveyReasons[] = {
    "expected {wanted}, found {found}",         "it is at position {position}",
    "it should be the first on the bus",        "it should follow {slave}",
    "it should hang at port {port} of {slave}",
};

}  // namespace syncline::words
