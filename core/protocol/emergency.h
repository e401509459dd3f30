// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace syncline::coe {

/// Service 1.
struct Emergency {
  std::uint16_t error_code = 0;
  std::uint8_t error_register = 0;
  std::array<std::uint8_t, 5> data{};
  bool operator==(const Emergency&) const = default;
};

}  // namespace syncline::coe
