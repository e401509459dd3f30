// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "support/random.h"

namespace syncline::fuzz {

/// A value replaced by a nasty one or by another of the text, an element doubled, moved or taken out, or a stray byte:
/// most of it is still XML, so that what is behind the parser is reached.
[[nodiscard]] std::string damage_xml(std::string_view text, Random& random);

}  // namespace syncline::fuzz
