// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "channels/snapshot.h"
#include "reasons/because.h"
#include "support/result.h"

/// What an application asks the master synchronisation, answered from the snapshot (emDcmGetStatus, emDcmGetAdjust,
/// emDcmGetBusShiftConfigured).
namespace syncline {

struct DcmAnswer {
  SyncState state = SyncState::kNotReady;  // kNotReady: no loop runs; kBusy: on its way; kInSync, kOutOfSync
  std::uint32_t error_code = 0;            // DCM_E_..., 0 = none
  std::int32_t difference_ns = 0;          // between set and actual value: now,
  double difference_mean_ns = 0;           // in the mean
  std::int32_t difference_max_ns = 0;      // and at most, since the status was reset
};
[[nodiscard]] inline DcmAnswer dcm_status(const Snapshot& snapshot) {
  const auto& dcm = snapshot.dcm;
  const bool runs = snapshot.online && dcm.mode != DcmMode::kOff;
  return {runs ? dcm.state : SyncState::kNotReady, dcm.error_code, dcm.error_ns, dcm.error_mean_ns, dcm.error_max_ns};
}

/// Adjustment that the host's timer needs, in thousandths of its rate. kNotSupported unless the timer is the
/// application's: mode master-shift-by-app, or control off.
[[nodiscard]] inline Result<double> dcm_adjust(const Snapshot& snapshot) {
  if (snapshot.dcm.control_off) return snapshot.dcm.adjust_permil;
  return fail(ErrorCode::kNotSupported, "master.dc.control_off",
              because("the controller moves the timer; set it to on first"));
}

[[nodiscard]] inline bool dcm_bus_shift_configured(const Snapshot& snapshot) {
  return snapshot.dcm.bus_shift_configured;
}

}  // namespace syncline
