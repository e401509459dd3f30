// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "channels/slave_request.h"
#include "channels/values/shared_text.h"
#include "support/brief_error.h"
#include "support/types.h"

namespace syncline {

/// Of one request, from 1 in the order of asking.
using RequestId = std::uint64_t;

/// One request on its way to the master and back, with all the room that its answer needs: made by who asks, filled by
/// the master's thread, which allocates and frees nothing for it. Belongs to one side at a time, but for the atomics.
struct RequestTicket {
  RequestId id = 0;
  SlaveRequest request;
  std::vector<std::uint8_t> bytes;    // what was read; of a refused file the slave's words
  std::vector<std::uint8_t> scratch;  // room for the work
  std::optional<BriefError> failure;
  std::optional<Error> error;  // instead, of what the state machine does: in words of its own
  SharedText slave;            // its name
  Nanoseconds answered = 0;
  std::atomic<std::uint32_t> done{0};  // bytes
  std::atomic<bool> cancelled{false};
};

}  // namespace syncline
