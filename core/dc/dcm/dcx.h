// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/dcm/dcm_controller.h"
#include "dc/dcm/master_shift.h"
#include "dc/dcm/write_forecast.h"

namespace syncline {
struct DcmSettings;
}  // namespace syncline

namespace syncline::dc {

/// Two segments in step: the reference clock follows an external clock that a bridge device shows, so that both are the
/// same in their cycles' phase, and the host's timer follows the reference clock.
class Dcx final : public DcmController {
 public:
  Dcx(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least = 0);
  void start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) override;
  std::optional<Nanoseconds> reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) override;
  DcmAction observe(const DcmObservation& observation) override;
  bool observe_second_write(const DcmObservation& observation) override;
  void set_led_by_substitute(bool substitute) override;
  void note_other_way() override { host_.note_other_way(); }
  [[nodiscard]] const DcmState& state() const override { return state_; }

 private:
  void take(const DcmObservation& observation);
  void forget();
  void note_closing(double moved, Nanoseconds passed);
  [[nodiscard]] double wanted_closing() const;
  void steer(Nanoseconds passed);
  void judge_external();

  bool control_off_, substitute_ = false;
  Nanoseconds cycle_, limit_;
  double slowness_;  // 1, or more in longer cycles
  MasterShift host_;
  DcmState state_;
  WriteForecast forecast_;
  Nanoseconds expected_lead_ = 0;  // of the reference clock before the host's clock, this cycle's noise left out
  std::optional<double> behind_;   // the reference clock behind the external one, within half a cycle
  double closing_ = 0;             // ppm by which it comes nearer to where the external one is ahead, filtered
  Nanoseconds seen_ = 0;           // host clock of behind_
  std::optional<Nanoseconds> known_since_;    // host clock; the external one
  double push_ = 0;                           // written beyond the forecast, ns, without integral_
  std::optional<Nanoseconds> near_since_;     // host clock; within the limit
  bool met_ = false;                          // since the external clock is known: was within the limit, and stayed
  bool apart_ = false;                        // has left it since, and not stayed there again
  std::optional<Nanoseconds> missing_since_;  // the external clock
  double integral_ = 0;
};

}  // namespace syncline::dc
