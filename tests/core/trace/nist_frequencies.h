// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace syncline {

/// Table 31 and the text about it in NIST SP 1065: 1000 fractional frequencies of a linear congruential generator.
inline std::vector<double> nist_frequencies() {
  std::vector<double> y;
  for (std::uint64_t n = 1234567890; y.size() < 1000; n = 16807 * n % 2147483647)
    y.push_back(static_cast<double>(n) / 2147483647);
  return y;
}

/// Phases of fractional frequencies at a distance of 1 s, the first one 0.
inline std::vector<double> phases_of(const std::vector<double>& y) {
  std::vector<double> x{0};
  for (const double value : y) x.push_back(x.back() + value);
  return x;
}

}  // namespace syncline
