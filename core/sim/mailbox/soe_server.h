// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <vector>

namespace syncline::sim {

/// IDNs of a simulated SoE drive: what is written to an element can be read there again. Messages in fragments are
/// refused.
class SoeServer {
 public:
  /// The answer to a message, header and data.
  [[nodiscard]] std::vector<std::uint8_t> respond(std::span<const std::uint8_t> request);

 private:
  std::map<std::tuple<std::uint8_t, std::uint16_t, std::uint8_t>, std::vector<std::uint8_t>>
      values_;  // drive, IDN, element
};

}  // namespace syncline::sim
