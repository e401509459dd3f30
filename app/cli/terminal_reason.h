// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "reasons/reason.h"

namespace syncline::cli {

/// Words that are said in the terminal alone, which speaks English: they need no row of the table of reasons.
[[nodiscard]] inline Reason in_terminal(std::string_view words) { return Reason::verbatim(std::string(words)); }

}  // namespace syncline::cli
