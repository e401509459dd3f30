// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct SlaveSettings;
}  // namespace syncline

namespace syncline::eni {

/// Wiring for slaves of which only the order is known: each hangs on the nearest one before it that has a free port of
/// the same physics (E-bus terminals on their coupler, the next coupler on the last one's cable port). Where no port
/// fits, a line.
void wire_in_order(std::vector<SlaveSettings>& slaves);

}  // namespace syncline::eni
