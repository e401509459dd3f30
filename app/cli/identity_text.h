// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "support/result.h"

namespace syncline {
struct Identity;
}  // namespace syncline

namespace syncline::cli {

/// VENDOR:PRODUCT[:REVISION[:SERIAL]], each decimal or 0x hexadecimal; what is left out is 0. kBadValue.
[[nodiscard]] Result<Identity> parse_identity(std::string_view text);

}  // namespace syncline::cli
