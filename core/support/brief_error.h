// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "reasons/brief_reason.h"
#include "support/result.h"

namespace syncline {

/// An error found where nothing may be allocated (the thread that runs the bus cycle): the facts alone. Who may
/// allocate makes an Error of them. Copied without allocating.
struct BriefError {
  ErrorCode code = ErrorCode::kMalformedData;
  BriefReason why{};                                   // detail
  std::int64_t expected = 0, received = 0, extra = 0;  // as in Error

  [[nodiscard]] Error about(std::string subject) const;
};

}  // namespace syncline
