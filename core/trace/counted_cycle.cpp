// SPDX-License-Identifier: Apache-2.0
#include "trace/counted_cycle.h"

#include "protocol/al_state.h"
#include "trace/untold.h"

namespace syncline {
namespace {

bool is_judged(SyncState state) { return state == SyncState::kInSync || state == SyncState::kOutOfSync; }

}  // namespace

bool is_run_in_op(const CycleSample& sample) {
  return static_cast<AlState>(sample.master_state) == AlState::kOp || !is_told(sample, kStateUntold);
}

bool counts_in_figures(const CycleSample& sample) {
  if (is_run_in_op(sample)) return true;
  const auto slaves = sample.slaves_sync, master = sample.master_sync;
  return (is_watched(slaves) || is_watched(master)) && (!is_watched(slaves) || is_judged(slaves)) &&
         (!is_watched(master) || is_judged(master));
}

}  // namespace syncline
