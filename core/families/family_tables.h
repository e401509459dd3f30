// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "families/device_family.h"

/// The rows, a vendor a file.
namespace syncline::families {

[[nodiscard]] std::span<const Family> yaskawa_families();
[[nodiscard]] std::span<const Family> copley_families();
[[nodiscard]] std::span<const Family> beckhoff_families();
[[nodiscard]] std::span<const Family> simulated_families();

}  // namespace syncline::families
