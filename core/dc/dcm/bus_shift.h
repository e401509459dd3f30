// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/dcm/dcm_controller.h"
#include "dc/dcm/drift_estimator.h"
#include "dc/dcm/phase_error.h"
#include "dc/dcm/sync_judge.h"

namespace syncline::dc {

/// The reference clock follows the host: each frame carries the time it ought to be when it passes. The
/// ESC's own control loop moves the clock; an outer integral takes away the standing error that this
/// loop needs until it has learned the drift.
class BusShift final : public DcmController {
 public:
  BusShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value);
  void start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) override;
  std::optional<Nanoseconds> reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) override;
  DcmAction observe(const DcmObservation& observation) override;
  [[nodiscard]] const DcmState& state() const override { return state_; }

 private:
  void update_state();

  PhaseTarget target_;
  SyncJudge judge_;
  DriftEstimator drift_;
  DcmState state_;
  Nanoseconds anchor_host_ = 0, anchor_reference_ = 0;
  double filtered_ = 0, integral_ = 0;
};

}  // namespace syncline::dc
