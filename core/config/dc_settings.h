// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "config/dcm_settings.h"
#include "support/types.h"

/// What the user decides about distributed clocks: of the master, and of one slave's SYNC0 and SYNC1.
namespace syncline {

/// Wire-ored SystemTimeDifference against 2^exponent - 1 ns for `settle_time_ms`.
struct SyncWindowSettings {
  bool enabled = false;
  std::uint8_t exponent = 7;            // 127 ns; 1..30
  std::uint32_t settle_time_ms = 1500;  // 0..60000
  bool operator==(const SyncWindowSettings&) const = default;
};

/// Start values of the time control loop in each ESC (ESC data sheet I, 9.1.4). The loop of a reference clock that the
/// master steers is not meant: it keeps the standard values, because what it is told carries the host's jitter.
struct DcLoopSettings {
  /// SpeedCounterStart 0x0930, 0x0080..0x3FFF. Empty: by the cycle time, see dc::speed_counter_start().
  std::optional<std::uint16_t> speed_counter_start;
  /// Exponents of the filters 0x0934 and 0x0935, 0..15. Empty: 0 and 8.
  std::optional<std::uint8_t> filter_depth_difference, filter_depth_speed_counter;
  bool operator==(const DcLoopSettings&) const = default;
};

/// Which notifications of the distributed clocks and of the DCM are told as events (EC_IOCTL_SET_NOTIFICATION_ENABLED).
struct DcNotificationSettings {
  bool reference_clock = true;
  bool slaves_in_sync = true;
  bool dc_status = true;
  bool dcm_in_sync = true;
  bool operator==(const DcNotificationSettings&) const = default;
};

struct DcMasterSettings {
  bool enabled = true;
  /// Position of the reference clock; empty: first slave with DC enabled.
  std::optional<std::uint16_t> reference_clock;
  /// The first slave on the bus that has a system time leads, whatever `reference_clock` and an ENI say.
  bool first_slave_is_reference_clock = false;
  /// Every slave that has a system time is synchronised, with or without a DC operation mode.
  bool all_slaves = false;
  bool continuous_propagation_compensation = false;
  bool show_64bit_system_time = false;
  SyncWindowSettings sync_window;
  DcmSettings dcm;
  std::uint32_t burst_total = 10'000;  // frames of the initial drift burst
  std::uint32_t burst_bulk = 12;       // frames a cycle in the burst
  bool burst_ends_early = true;        // when all slaves have settled
  std::uint8_t delay_rounds = 20;      // latches whose medians give the propagation delays; 1..100
  /// Processing minus forwarding latency of the ESCs, ns. Empty: 40, which is an ET1100's.
  std::optional<std::uint32_t> delay_difference;
  DcLoopSettings loop;
  DcNotificationSettings notifications;
  Nanoseconds start_time_safety = 5 * kMillisecond;
  Nanoseconds start_time_grid = 0;  // 0: the cycle
  /// Added to the SYNC0 shift of slaves that are based on the input reference: they latch inputs for the next frame.
  Nanoseconds input_shift = 0;
  bool operator==(const DcMasterSettings&) const = default;
};

/// The user's choice for one SYNC unit; empty optionals follow the operation mode of the ESI.
struct SyncUnitSettings {
  /// Sync Unit Cycle factor: > 0 multiplies, < 0 divides the bus cycle.
  std::optional<int> cycle_factor;
  std::optional<Nanoseconds> user_cycle;  // overrides the factor
  std::optional<Nanoseconds> shift;       // user shift, may be negative
  bool operator==(const SyncUnitSettings&) const = default;
};

struct DcSlaveSettings {
  std::string op_mode;  // name of the ESI OpMode; "" = DC off (no DC commands)
  SyncUnitSettings sync0, sync1;
  /// SYNC0 is based on the master's input reference. Empty: as the operation mode says (ESI ShiftTimeSync0@Input).
  std::optional<bool> input_reference;
  bool potential_reference_clock = false;
  bool operator==(const DcSlaveSettings&) const = default;
};

}  // namespace syncline
