// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "support/types.h"

namespace syncline {
struct Identity;
struct SlaveEvidence;
}  // namespace syncline

namespace syncline::ui {

/// What a device needs from its outputs to SYNC0, ns: as it has told (0x1C32:06), else as its family is known. `told`:
/// null where nobody has asked it.
[[nodiscard]] std::optional<Nanoseconds> calcAndCopy(const Identity& identity, const SlaveEvidence* told);

}  // namespace syncline::ui
