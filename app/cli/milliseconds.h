// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/types.h"

namespace syncline::cli {

/// Of a moment or an age, in whole microseconds: what lies below is no news to a reader, and would be noise in a file.
[[nodiscard]] inline double milliseconds(Nanoseconds time) {
  const Nanoseconds whole = time / kMicrosecond;
  return static_cast<double>(whole) / 1000;
}

[[nodiscard]] inline double seconds(Nanoseconds time) { return static_cast<double>(time) / 1e9; }

}  // namespace syncline::cli
