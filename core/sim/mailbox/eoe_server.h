// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace syncline::sim {

/// EoE of a simulated device: it takes and gives its IP parameters, and has no network behind it.
class EoeServer {
 public:
  void reset() { parameters_.clear(); }
  /// The answer to a message, header and data; nothing for a frame, which goes nowhere.
  [[nodiscard]] std::vector<std::uint8_t> respond(std::span<const std::uint8_t> request);
  /// What the last "set IP parameter" carried.
  [[nodiscard]] const std::vector<std::uint8_t>& parameters() const { return parameters_; }

 private:
  std::vector<std::uint8_t> parameters_;
};

}  // namespace syncline::sim
