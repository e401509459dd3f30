// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace syncline {

struct PreviousPort;

/// The own port towards the master of every slave of a wiring, in the order in which frames pass the processing units.
/// A slave that stands behind one that hangs at it is entered by another port than 0: what hangs at its ports from the
/// entry up to port 0 is passed before its processing unit (ESC data sheet I, 3.2: 0, processing unit, 3, 1, 2). Port 0
/// wherever that explains the order. Empty where no port does, for a slave that hangs at itself, and in a circle. Pure.
[[nodiscard]] std::vector<std::optional<std::uint8_t>> entry_ports(
    std::span<const std::optional<PreviousPort>> previous);

}  // namespace syncline
