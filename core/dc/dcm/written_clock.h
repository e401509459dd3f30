// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/dcm/changed_way.h"
#include "dc/dcm/dcm_controller.h"
#include "dc/dcm/dcm_monitor.h"
#include "dc/dcm/phase_error.h"
#include "dc/dcm/substitute_push.h"

namespace syncline {
struct DcmSettings;
}  // namespace syncline

namespace syncline::dc {

/// The reference clock is written the master's time without a control loop; the ESC's own loop does the rest.
/// MasterRefClock writes the nominal time of the cycle, so that the host's jitter reaches the clock as it is, and the
/// clock shows the nominal time when a frame passes that was as late as usual: that is no error of the schedule. Of a
/// frame that leaves more than 3 us off its usual place (the host stood still, or it has tails) the clock is told the
/// time of that, less what is usual: it would lead all the others away by more than they are allowed. A stamp may be
/// wrong by more than that, too, or a frame held up behind it: the clock shows it as the frame passes, and another
/// write at once (DcmAction::write_again) tells it as much less, so that nothing is left in the mean of its loop. A
/// substitute is pushed to its place instead (SubstitutePush).
/// LinkLayerRefClock writes the time at which the adapter says that it sends. Those stamps are exact: where the clock
/// differs from one cycle to the next from what it was told, it was not the clock that moved but the way to it, because
/// a slave in front of it came or went, or another clock leads. What it is told is then counted from its new place, and
/// it is told so at once (DcmAction::write_again), so that nobody is moved. (A clock that steps by no more than that
/// leaves its followers, who show it.)
class WrittenClock final : public DcmController {
 public:
  enum class Time : std::uint8_t { kNominal, kOfSending };
  WrittenClock(Time time, const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value,
               Nanoseconds least);
  void start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) override;
  std::optional<Nanoseconds> reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) override;
  DcmAction observe(const DcmObservation& observation) override;
  bool observe_second_write(const DcmObservation& observation) override;
  void set_led_by_substitute(bool substitute) override;
  void note_other_way() override;
  [[nodiscard]] const DcmState& state() const override { return state_; }

 private:
  [[nodiscard]] Nanoseconds lag_of(const DcmObservation& observation) const;
  /// Whether what was told is to be put right by another write.
  [[nodiscard]] bool tells_again(const DcmObservation& observation, Nanoseconds lag);
  /// The clock was at `lag` from what it was told. What is left of that when the way has changed.
  [[nodiscard]] Nanoseconds without_way(const DcmObservation& observation, Nanoseconds lag, DcmAction& action);
  void learn_lateness(const DcmObservation& observation);
  [[nodiscard]] bool knows_usual() const;
  /// This cycle's message was wrong by far, and not all of those before it were.
  [[nodiscard]] bool was_shaken(Nanoseconds reference_time);
  [[nodiscard]] Nanoseconds usual_lateness() const;
  [[nodiscard]] Nanoseconds wanted_at(Nanoseconds host_time) const {
    return reference_ + (host_time - host_) + way_.offset();
  }

  Time time_;
  PhaseTarget target_;
  DcmMonitor monitor_;
  DcmState state_;
  ChangedWay way_;
  Nanoseconds host_ = 0, reference_ = 0;  // host time and what the reference clock is to show then
  double usual_lateness_ = 0;             // ns
  Nanoseconds told_ = 0;                  // last, in the mode of nominal times
  Nanoseconds wrong_ = 0;                 // what the clock was told, by its own reading; of the last cycle
  Nanoseconds owed_ = 0;                  // to be told more with the next message
  bool again_ = false;                    // the next message is such another one
  SubstitutePush push_;                   // in that mode
  bool substitute_ = false;               // leads
  int far_ = 0;  // cycles in a row with a message that was far wrong and could not be paid back
  Nanoseconds last_lag_ = 0, last_time_ = 0, way_changed_ = 0;
  Nanoseconds cycle_, in_sync_limit_;
  int observed_ = 0;  // cycles, no more than count
};

}  // namespace syncline::dc
