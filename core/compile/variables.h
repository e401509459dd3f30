// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "config/pdo_description.h"

namespace syncline {
struct Variable;
}  // namespace syncline

namespace syncline::compiler {

struct SlavePlan;

/// Variables of one direction: `slave.PDO.entry`, padding left out, in slave and PDO order. Names are unique: the
/// second of the same name gets " (2)". `placement_bits[i]` is the image bit at which slave i's data of this direction
/// start.
[[nodiscard]] std::vector<Variable> image_variables(const std::vector<SlavePlan>& slaves, PdoDirection direction,
                                                    const std::vector<std::uint32_t>& placement_bits);

}  // namespace syncline::compiler
