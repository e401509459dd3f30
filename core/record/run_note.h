// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/types.h"

namespace syncline {

/// What the user wrote at a moment of a run.
struct RunNote {
  Nanoseconds time = 0;  // host clock
  std::string text;
  bool operator==(const RunNote&) const = default;
};

}  // namespace syncline
