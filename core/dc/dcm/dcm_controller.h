// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "channels/values/sync_obstacle.h"
#include "support/types.h"

namespace syncline {
struct DcmSettings;
}  // namespace syncline

/// Master synchronisation (DCM): brings the send time of the cyclic frame and the system time of the
/// reference clock together.
namespace syncline::dc {

/// What one cycle showed. Times in ns; reference_time is the reference clock's system time when the
/// cyclic frame passed it (the ARMW value), extended to 64 bit.
struct DcmObservation {
  Nanoseconds send_time = 0;                  // host clock, when the frame was really sent
  Nanoseconds scheduled_time = 0;             // host clock, when it should have been sent
  std::optional<Nanoseconds> reference_time;  // empty: frame lost or reference clock silent
  /// DCX: time of the external clock less that of the segment, from the bridge; and whether it ought to be there.
  std::optional<Nanoseconds> external_difference{};
  bool external_expected = false;
  /// From the stamp for which a time was written into the frame until send_time, where the link knows that better.
  Nanoseconds way_out = 0;
  /// So much later than send_time the frame may have left, at most: it came back later than frames can. 0: it did not.
  Nanoseconds stamp_doubt = 0;
};

/// What to do next.
struct DcmAction {
  Nanoseconds period_adjust = 0;  // master shift: added to the next period
  /// What the frame told the reference clock was wrong: in bus shift and with nominal times because it left far from
  /// its stamp, in the link layer's mode because its way was another one. Another write at once (reference_write) takes
  /// it back before the clock has gone astray for a whole cycle.
  bool write_again = false;
};

struct DcmState {
  Nanoseconds error = 0;  // frame late in the SYNC grid > 0
  Nanoseconds error_filtered = 0;
  /// Of the host's lateness, what the reference clock has made its own: frames that are so late are in their place.
  Nanoseconds usual_lateness = 0;
  double drift_ppm = 0;                        // reference clock's rate minus host's
  std::optional<double> drift_half_width_ppm;  // of its 95 % interval; nothing while too little is known for one
  Nanoseconds adjust = 0;        // of the next period, or of what is written; with control off: what it would be
  double output_sum = 0;         // what the controller has learned: its integral part, ns a cycle
  Nanoseconds output_total = 0;  // of all adjustments since the start
  bool in_sync = false;          // error within the limit for the settle time, and no error code
  std::optional<Nanoseconds> in_sync_after;   // since the first observation
  std::optional<Nanoseconds> clock_step;      // the reference clock stepped by so much, as this cycle made sure
  std::uint32_t error_code = 0;               // DCM_E_...
  std::optional<Nanoseconds> external_error;  // DCX: the reference clock ahead of the external one, within half a cycle
  SyncObstacle external = SyncObstacle::kNone;  // the same beyond the limit: kToExternalClock or kExternalClock
};

/// In DCX the reference clock goes faster and slower than the external one by no more than this: slaves follow one that
/// changes its rate about 8 ms behind in cycles of 1 ms, so that they stay within a window of 127 ns. Who is half a
/// millisecond away needs a minute.
inline constexpr double kDcxFastestPpm = 8;
/// In the mode of nominal times (master-ref-clock) a frame that leaves no further than this from its usual place is
/// told the nominal time, and any other that of its sending, ns: stamps are themselves wrong by so much on a quiet host
/// (one in a hundred), and the clock's loop lets 50 ns of it through.
inline constexpr Nanoseconds kMostShakenByNominal = 3'000;

class DcmController {
 public:
  virtual ~DcmController() = default;
  /// `base`: phase of the SYNC0 grid in system time, SYNC0 at base + n * cycle. Starts the statistics.
  virtual void start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) = 0;
  /// Just before frame k is sent: the bus-shift value needs the real send time.
  virtual std::optional<Nanoseconds> reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) = 0;
  virtual DcmAction observe(const DcmObservation& observation) = 0;
  /// What the write that was asked for (DcmAction::write_again) found: the reference clock's time when it passed, as in
  /// an observation. Not called when that frame did not come back. True: that one, too, left far from its stamp.
  virtual bool observe_second_write(const DcmObservation& /*observation*/) { return false; }
  /// Another clock leads from now on than was to: one whose control loop is that of those who follow, and learns
  /// quickly what it is told; or no longer. Nobody's after start().
  virtual void set_led_by_substitute(bool /*substitute*/) {}
  /// Slaves in front of the clock that leads have come or gone, or another one leads: its readings are elsewhere.
  virtual void note_other_way() {}
  [[nodiscard]] virtual const DcmState& state() const = 0;
};

/// `set_value`: wanted distance from frame send to SYNC0. `least_set_value`: frame time plus propagation delay, below
/// which the controller reports DCM_E_INVALID_SETVAL.
[[nodiscard]] std::unique_ptr<DcmController> make_dcm_controller(const DcmSettings& settings, Nanoseconds cycle_time,
                                                                 Nanoseconds set_value,
                                                                 Nanoseconds least_set_value = 0);

/// Hz at which the loop of this mode swings back after a disturbance: the settled gains of a master shift. Nothing
/// where it does not swing, or where the controller does not close one alone (bus shift: the ESC's own loop is part of
/// it).
[[nodiscard]] std::optional<double> loop_frequency(const DcmSettings& settings, Nanoseconds cycle_time);

}  // namespace syncline::dc
