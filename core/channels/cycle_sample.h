// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "channels/values/stamp_source.h"
#include "channels/values/sync_state.h"
#include "channels/watch_command.h"
#include "support/types.h"

namespace syncline {

/// One bus cycle, stamped by the cyclic thread. Trivially copyable.
struct CycleSample {
  std::uint64_t cycle = 0;            // counts from going online
  Nanoseconds send_time = 0;          // host clock, just before the frame was handed to the link
  Nanoseconds reference_time = 0;     // system time of the reference clock when the frame passed, 0 = none
  Nanoseconds sync_base = 0;          // SYNC0 of a slave lies here + n * grid + its shift in system time
  std::int32_t wake_lateness_ns = 0;  // send_time minus the scheduled time
  std::int32_t round_trip_ns = 0;
  std::int32_t dcm_error_ns = 0;  // controller error, raw
  std::int32_t dcm_error_filtered_ns = 0;
  float drift_ppm = 0;                   // host clock against reference clock
  std::int32_t dcm_adjust_ns = 0;        // of the next period, or of what is written to the reference clock
  float dcm_output_sum_ns = 0;           // what the controller has learned, ns a cycle
  std::int64_t dcm_output_total_ns = 0;  // all adjustments since it was started
  std::uint32_t dcm_error_code = 0;      // DCM_E_..., 0 = none
  static constexpr std::int32_t kNoExternalClock = std::numeric_limits<std::int32_t>::min();
  std::int32_t external_error_ns = kNoExternalClock;  // DCX: as DcmStatus::external_error_ns
  std::uint32_t deviation_ored_ns = 0;                // magnitude of the wire-ored 0x092C of all clocks
  std::uint32_t deviation_ns = 0;       // of the slaves that follow the reference clock: the or-ed value where it ors
                                        // only them, else the largest of their latest readings
  std::int32_t slave_deviation_ns = 0;  // signed 0x092C of slave_position
  std::uint32_t slave_sm2_missed = 0;   // of sm2_position, see Sm2MissedStatus::total
  std::uint32_t slave_sm2_integrator = 0;  // see Sm2MissedStatus::integrator
  std::int16_t slave_position = -1;        // round robin, -1 = none in this cycle
  std::int16_t sm2_position = -1;
  std::uint16_t wkc_expected = 0;  // sum over the process-data commands
  std::uint16_t wkc_received = 0;
  std::uint16_t frames_lost = 0;     // of this cycle: not back at its deadline
  std::uint16_t skipped_cycles = 0;  // left out just before this one: the host came too late for them
  std::int32_t late_by_ns = 0;       // a frame of an earlier cycle came back in this one, so long after its deadline
  enum Flag : std::uint16_t {
    kFrameLost = 1,
    kWkcError = 2,
    kDeviationValid = 4,
    kDcmActive = 8,
    kReferenceValid = 128,
    kOverrun = 256,
    kFrameLate = 512,       // late_by_ns is valid
    kSyncBaseValid = 4096,  // sync_base is valid
    kFollowersRead = 2048,  // deviation_ns is valid
    kSlaveFollows = 1024,   // slave_position follows the reference clock: what it shows is a deviation
  };
  std::uint16_t flags = 0;
  std::uint8_t master_state = 0;                  // AlState
  StampSource stamped_by = StampSource::kUntold;  // send_time
  std::int32_t stamp_doubt_ns = -1;  // the frame came back so much later than the quickest: its stamps, of sending and
                                     // of arrival, are wrong by no more; -1: not known
  /// The two verdicts of this cycle, as DcStatus::state and DcmStatus::state.
  SyncState slaves_sync = SyncState::kNotMonitored, master_sync = SyncState::kNotMonitored;
  /// Variables of the process image that somebody watches (WatchCommand): inputs as they came back in this cycle,
  /// outputs as they went out with it.
  std::uint16_t watched_known = 0;                    // a bit a place of the list: it has a value
  std::uint32_t watch_list = 0;                       // whose places these are; 0 = none
  std::array<std::uint64_t, kMostWatched> watched{};  // bits of each, the lowest first; 0 without a value
};

}  // namespace syncline
