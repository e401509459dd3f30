// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "channels/dc_status.h"
#include "channels/dcm_status.h"

/// What the two verdicts come to for those who ask yes or no: exit codes, JSON, lamps, findings. How they are reached
/// is core/dc's (sync_verdict, master_verdict); nobody else makes a yes of readings.
namespace syncline {

/// Nothing while nobody judges: no distributed clocks, no monitoring, or nobody follows.
[[nodiscard]] inline std::optional<bool> slaves_in_sync(const DcStatus& dc) {
  if (!dc.enabled || !is_watched(dc.state)) return std::nullopt;
  return dc.state == SyncState::kInSync;
}

/// Nothing without master synchronisation.
[[nodiscard]] inline std::optional<bool> master_in_sync(const DcmStatus& dcm) {
  if (dcm.mode == DcmMode::kOff) return std::nullopt;
  return dcm.state == SyncState::kInSync;
}

/// Nobody who is asked to come in sync is missing: the master with control off is not, nor who does not judge.
[[nodiscard]] inline bool is_synchronised(const DcStatus& dc, const DcmStatus& dcm) {
  const bool slaves = !dc.monitored || slaves_in_sync(dc).value_or(true);
  const bool master = !dc.enabled || dcm.control_off || master_in_sync(dcm).value_or(true);
  return slaves && master;
}

}  // namespace syncline
