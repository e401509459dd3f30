// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// Object 0x10F1, sync error setting: so many does a missed SM event add to the internal error counter; a good one
/// takes 1 away. The device leaves OP when the counter gets to 0x10F1:02 (Yaskawa SGD7S manual, sync error; ETG.1020).
inline constexpr std::uint32_t kMissWeight = 3;

}  // namespace syncline
