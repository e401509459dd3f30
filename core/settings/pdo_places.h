// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace syncline {
struct SlaveSettings;
}  // namespace syncline

namespace syncline::settings {

struct Place;

/// A place for each PDO of the slave and its modules: outputs, then inputs, each index once.
[[nodiscard]] std::vector<Place> pdo_places(const SlaveSettings& settings, std::size_t slave);

/// A place for each entry of these PDOs that is no padding: item is the PDO, sub the entry's number.
[[nodiscard]] std::vector<Place> entry_places(const SlaveSettings& settings, std::size_t slave);

}  // namespace syncline::settings
