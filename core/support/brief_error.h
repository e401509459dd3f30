// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "support/result.h"

namespace syncline {

/// An error found where nothing may be allocated (the thread that runs the bus cycle): the facts alone. Who may
/// allocate makes an Error of them. Copied without allocating.
struct BriefError {
  ErrorCode code = ErrorCode::kMalformedData;
  const char* why = "";  // detail, for the program's life; {0} and {1} stand for the numbers, {2} for the word
  std::int64_t a = 0, b = 0;
  std::string_view word{};                             // for the program's life
  std::int64_t expected = 0, received = 0, extra = 0;  // as in Error

  [[nodiscard]] Error about(std::string subject) const;
};

}  // namespace syncline
