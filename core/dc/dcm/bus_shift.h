// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/dcm/dcm_controller.h"
#include "dc/dcm/dcm_monitor.h"
#include "dc/dcm/phase_error.h"

namespace syncline::dc {

/// The reference clock follows the host: each frame carries the time that it ought to be when it passes.
/// The ESC's own control loop moves the clock; an outer integral takes away the standing error that this
/// loop needs until it has learned the drift.
///
/// Until in sync the whole error is written, so that the clock comes quickly. Afterwards the time is
/// predicted from the last reading, and only a share of the error is corrected: what is wrong with one send
/// stamp then mostly cancels with the next, instead of shaking the reference clock and all slaves with it.
class BusShift final : public DcmController {
 public:
  BusShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value);
  void start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) override;
  std::optional<Nanoseconds> reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) override;
  DcmAction observe(const DcmObservation& observation) override;
  [[nodiscard]] const DcmState& state() const override { return state_; }

 private:
  struct Reading {
    Nanoseconds host_time = 0, reference_time = 0;
  };
  [[nodiscard]] Nanoseconds wanted_at(Nanoseconds host_time) const;
  [[nodiscard]] double track_share() const;
  [[nodiscard]] bool predicts(Nanoseconds send_time) const;
  void correct(double lag);
  void watch_runaway();

  PhaseTarget target_;
  DcmMonitor monitor_;
  DcmState state_;
  Reading anchor_;                // host time and what the reference clock is to show then
  std::optional<Reading> last_;
  double filtered_ = 0, integral_ = 0;
  bool tracking_ = false;
  int blocks_away_ = 0;
};

}  // namespace syncline::dc
