// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/dcm/changed_way.h"
#include "dc/dcm/dcm_controller.h"
#include "dc/dcm/dcm_monitor.h"
#include "dc/dcm/phase_error.h"
#include "dc/dcm/phase_tracker.h"

namespace syncline {
struct DcmSettings;
}  // namespace syncline

namespace syncline::dc {

/// The host's timer follows the reference clock: the next period is longer or shorter by the drift that the tracker has
/// learned and a share of the phase that it sees. When the application moves the timer (MasterShiftByApp), or control
/// is off, the adjustment is only reported.
class MasterShift final : public DcmController {
 public:
  MasterShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least = 0);
  void start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) override;
  std::optional<Nanoseconds> reference_write(Nanoseconds, Nanoseconds) override { return std::nullopt; }
  DcmAction observe(const DcmObservation& observation) override;
  void note_other_way() override;
  [[nodiscard]] const DcmState& state() const override { return state_; }

 private:
  void follow(const DcmObservation& observation);
  [[nodiscard]] Nanoseconds error_of(const DcmObservation& observation);

  bool moves_timer_;
  PhaseTarget target_;
  DcmMonitor monitor_;
  PhaseTracker tracker_;
  DcmState state_;
  ChangedWay way_;
  std::optional<Nanoseconds> last_scheduled_;
};

}  // namespace syncline::dc
