// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace syncline::sim {

/// ADS of a simulated device: a memory by index group and offset, written and read with the ADS commands of these
/// names.
class AoeServer {
 public:
  /// The answer to a message, header and data; nothing for what is no request.
  [[nodiscard]] std::vector<std::uint8_t> respond(std::span<const std::uint8_t> request);

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint8_t>> values_;
};

}  // namespace syncline::sim
