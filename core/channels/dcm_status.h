// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "channels/values/sync_obstacle.h"
#include "channels/values/sync_state.h"
#include "config/dcm_settings.h"
#include "support/types.h"

namespace syncline {

/// Whether the master is in sync with the reference clock (dc/master_verdict.h), and what its controller (DCM) does.
struct DcmStatus {
  DcmMode mode = DcmMode::kOff;
  SyncState state = SyncState::kNotReady;
  std::int32_t error_ns = 0, error_filtered_ns = 0;
  double drift_ppm = 0;
  std::optional<double> drift_half_width_ppm;  // half of its 95 % interval; nothing while too little is known for one
  double error_mean_ns = 0, error_rms_ns = 0;  // since in sync
  std::int32_t error_max_ns = 0;
  std::int32_t frame_error_ns = 0;      // error of the frame: that of the schedule, and how late it was sent
  std::int32_t frame_error_max_ns = 0;  // since in sync
  std::int32_t late_allowed_ns = 0;     // frame error at which a frame meets SYNC0 at the last slave
  std::uint64_t late_sends = 0;         // frames sent later than that
  dc::SyncObstacle obstacle = dc::SyncObstacle::kNone;  // why it is not in sync
  std::optional<double> in_sync_after_ms;               // from the first cyclic frame
  std::optional<std::int32_t> external_error_ns;        // DCX: reference clock ahead of the external, in the cycle
  std::uint32_t error_code = 0;                         // EC-Master DCM codes, 0 = none
  std::int32_t set_value_ns = 0;
  Nanoseconds in_sync_limit = 0;       // by which it is judged now
  std::uint32_t times_configured = 0;  // other parameters were taken while it ran
  double adjust_permil = 0;            // of the host's timer: applied, or wanted when control is off or by application
  bool control_off = false;            // or left to the application
  bool bus_shift_configured = false;   // the cyclic frames can steer the reference clock
  bool operator==(const DcmStatus&) const = default;
};

}  // namespace syncline
