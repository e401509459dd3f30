// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "channels/dc_status.h"
#include "channels/dcm_status.h"
#include "channels/host_status.h"
#include "channels/slave_status.h"
#include "protocol/al_state.h"
#include "support/types.h"

namespace syncline {

/// The latest of everything that has a state.
struct Snapshot {
  Nanoseconds time = 0;
  bool online = false;
  bool link_up = false;
  AlState state = AlState::kNone;  // of the master: lowest of all slaves, kNone while one does not answer
  AlState requested = AlState::kNone;
  std::uint64_t cycles = 0;
  std::uint64_t lost_frames = 0;  // not back at their deadline, and not come since
  std::uint64_t late_frames = 0;  // came back after their deadline
  std::uint64_t wkc_errors = 0;
  std::uint64_t overruns = 0;        // times that cycles were left out because the host came too late
  std::uint64_t skipped_cycles = 0;  // cycles left out
  std::uint32_t forced_bits = 0;     // of the outputs, see ForceOutputCommand
  Nanoseconds cycle_time = 0;
  std::vector<SlaveStatus> slaves;  // sized once when a configuration is taken
  DcStatus dc;
  DcmStatus dcm;
  HostStatus host;
};

}  // namespace syncline
