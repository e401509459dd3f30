// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/dcm/dcm_controller.h"
#include "dc/dcm/dcm_monitor.h"
#include "dc/dcm/phase_error.h"

namespace syncline::dc {

/// The host's timer follows the reference clock: a PI controller lengthens or shortens the next
/// period. Fast gains while not in sync, slow ones while in sync.
class MasterShift final : public DcmController {
 public:
  MasterShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least = 0);
  void start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) override;
  std::optional<Nanoseconds> reference_write(Nanoseconds, Nanoseconds) override { return std::nullopt; }
  DcmAction observe(const DcmObservation& observation) override;
  [[nodiscard]] const DcmState& state() const override { return state_; }

 private:
  [[nodiscard]] bool is_gated(double error);
  void control(double error);

  PhaseTarget target_;
  DcmMonitor monitor_;
  DcmState state_;
  double smoothed_ = 0, integral_ = 0, output_ = 0;  // ns, ns a cycle, ns
  int outliers_ = 0;
};

}  // namespace syncline::dc
