// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "support/types.h"

namespace syncline {

/// How host and reference clock are brought together (EC-Master DCM modes).
enum class DcmMode : std::uint8_t {
  kOff,
  kBusShift,           // the reference clock follows the host, in a control loop
  kMasterShift,        // the host's timer follows the reference clock
  kMasterRefClock,     // the reference clock is written the nominal time, without a control loop
  kLinkLayerRefClock,  // as bus shift, with the time that the network adapter puts into the frame while sending
  kDcx,                // the reference clock follows an external one through a bridge device, the host follows it
  kMasterShiftByApp,   // as master shift, but the application moves the timer; the controller says by how much
};
[[nodiscard]] std::string_view dcm_mode_name(DcmMode mode);  // "bus-shift"
[[nodiscard]] std::optional<DcmMode> dcm_mode_from_name(std::string_view name);

/// The mode needs a cyclic command that writes the reference clock's system time (0x0910).
[[nodiscard]] constexpr bool steers_reference_clock(DcmMode mode) {
  return mode == DcmMode::kBusShift || mode == DcmMode::kMasterRefClock || mode == DcmMode::kLinkLayerRefClock ||
         mode == DcmMode::kDcx;
}
/// The controller of this mode moves the host's timer.
[[nodiscard]] constexpr bool moves_host_timer(DcmMode mode) {
  return mode == DcmMode::kMasterShift || mode == DcmMode::kDcx;
}

/// Controller of the send phase: the members of EC_T_DCM_CONFIG_* under their meanings. Numbers for which the EC-Master
/// manual says "0 lets the current setting unmodified" keep that meaning; with nothing set before, it is the default.
struct DcmSettings {
  DcmMode mode = DcmMode::kBusShift;
  /// Distance from the cyclic frame's send time to SYNC0, ns (nCtlSetVal). Empty: see effective_set_value().
  std::optional<Nanoseconds> set_value;
  /// Share of the error that is corrected in one cycle while in sync, in thousandths (nCtlGain); 0..500.
  std::uint32_t gain_ppt = 2;
  /// Multiplies the integral gain, whose critically damped value belongs to 1 (nCtlDriftErrorGain); 0..16.
  std::uint32_t drift_error_gain = 3;
  /// Errors further than this from what is expected are no valid readings, ns (nMaxValidVal); 0..1 s.
  Nanoseconds max_valid_value = 3'000;
  Nanoseconds in_sync_limit = 4'000;            // dwInSyncLimit, ns; 0..1 s
  std::uint32_t in_sync_settle_time_ms = 1500;  // dwInSyncSettleTime; 0..60000
  std::uint32_t start_delay_ms = 0;             // dwInSyncStartDelayCycle: before the errors are judged; 0..600000
  bool control_off = false;                     // bCtlOff: nothing is moved, the natural drift is shown
  bool standard_loop_values = false;            // bUseDcLoopCtlStdValues: 0x0930 and 0x0934 are left alone
  bool log = false;                             // bLogEnabled
  bool operator==(const DcmSettings&) const = default;

  static constexpr std::uint32_t kMaxGain = 500, kMaxDriftErrorGain = 16;
};

/// `change` in force on top of `current`: its zeros leave what is.
[[nodiscard]] DcmSettings merge_dcm_settings(const DcmSettings& current, DcmSettings change);
/// With the defaults for zeros.
[[nodiscard]] DcmSettings effective_dcm_settings(const DcmSettings& settings);
/// Where none is chosen: two thirds of the cycle; or, on a bus so long that outputs are at the last slave less than a
/// tenth of the cycle before that, half way between them and the next frame. `outputs_there`: since sending, ns; 0: not
/// known yet.
[[nodiscard]] Nanoseconds effective_set_value(const DcmSettings& settings, Nanoseconds cycle_time,
                                              Nanoseconds outputs_there = 0);

}  // namespace syncline
