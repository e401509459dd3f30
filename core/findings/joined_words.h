// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "findings/finding.h"

namespace syncline::words {

/// Tables one behind the other.
template <std::size_t... kRows>
[[nodiscard]] consteval std::array<FindingWords, (kRows + ...)> joined(const FindingWords (&... tables)[kRows]) {
  std::array<FindingWords, (kRows + ...)> all{};
  auto at = all.begin();
  ((at = std::copy_n(tables, kRows, at)), ...);
  return all;
}

}  // namespace syncline::words
