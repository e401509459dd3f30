// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

/// The rows, a vendor a file.
namespace syncline::families {

struct Family;

[[nodiscard]] std::span<const Family> yaskawa_families();
[[nodiscard]] std::span<const Family> copley_families();
[[nodiscard]] std::span<const Family> beckhoff_families();
[[nodiscard]] std::span<const Family> simulated_families();

}  // namespace syncline::families
