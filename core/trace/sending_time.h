// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "channels/cycle_sample.h"
#include "protocol/al_state.h"

namespace syncline {

/// Whether it matters when this cycle was sent: somebody takes process data out of it, or clocks are controlled with
/// its times. Not in OP alone, which a host that is late never reaches, or loses.
[[nodiscard]] constexpr bool sending_time_matters(const CycleSample& sample) {
  return has_process_data_communication(static_cast<AlState>(sample.master_state)) ||
         (sample.flags & CycleSample::kDcmActive) != 0;
}

}  // namespace syncline
