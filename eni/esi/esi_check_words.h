// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "config/identity.h"

namespace syncline::eni {

struct RevisionCheckWord {
  std::string_view text;
  RevisionCheck check;
};
/// Type@CheckRevisionNo.
inline constexpr std::array<RevisionCheckWord, 5> kRevisionChecks{{
    {"NONE", RevisionCheck::kNone},
    {"EQ", RevisionCheck::kEqual},
    {"EQ_OR_G", RevisionCheck::kEqualOrGreater},
    {"LW_EQ", RevisionCheck::kLowWordEqual},
    {"LW_EQ_HW_EQ_OR_G", RevisionCheck::kLowWordEqualHighWordEqualOrGreater},
}};

}  // namespace syncline::eni
