// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace syncline::coe {

/// CoE data type number (ETG.1000.6, table 64) as ESI names it; by its width where the number has no name there.
[[nodiscard]] std::string esi_type_name(std::uint16_t type, unsigned bits);

}  // namespace syncline::coe
