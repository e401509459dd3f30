// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Distributed clocks as the ESI describes them: what a device can do and its operation modes.
namespace syncline {

/// CycleTimeSync0/1 and ShiftTimeSync0/1 of an OpMode: fixed value (ns) or factor of the Sync Unit
/// Cycle; reference/eni rules in config/sync0_cycle.h.
struct DcTime {
  std::int64_t value_ns = 0;
  std::optional<int> factor;
  bool input = false;  // ShiftTimeSync0@Input
  /// From the SYNC signal to outputs at the terminals, and to inputs being latched (ShiftTimeSync0/1).
  std::optional<std::int64_t> output_delay_ns{}, input_delay_ns{};
  bool operator==(const DcTime&) const = default;
};

/// Sm/CycleTime and Sm/ShiftTime of an OpMode.
struct OpModeTime {
  std::int64_t value_ns = 0;
  std::optional<int> factor{};                                             // CycleTime
  std::optional<std::int64_t> min_after_sync_ns{}, min_before_frame_ns{};  // ShiftTime
  bool operator==(const OpModeTime&) const = default;
};

struct PdoOversampling {
  std::uint16_t pdo = 0;
  std::uint16_t factor = 1;
  bool operator==(const PdoOversampling&) const = default;
};

struct OpModeSyncManager {
  std::uint8_t number = 0;
  std::optional<std::uint16_t> sync_type;       // -> 0x1C32/0x1C33:01
  std::vector<std::uint16_t> pdos;              // assignment of that mode, empty = unchanged
  std::vector<PdoOversampling> oversampling{};  // Pdo@OSFac, of PDOs in `pdos`
  std::optional<OpModeTime> cycle_time{}, shift_time{};
  bool operator==(const OpModeSyncManager&) const = default;
};

struct DcOpMode {
  std::string name;
  std::string description;
  std::uint16_t assign_activate = 0;
  DcTime cycle_time_sync0, shift_time_sync0, cycle_time_sync1, shift_time_sync1;
  std::vector<OpModeSyncManager> sync_managers;
  bool operator==(const DcOpMode&) const = default;
};

struct DcDescription {
  bool time_loop_control_only = false;
  bool unknown_frmw = false;
  bool unknown_64bit = false;
  bool potential_reference_clock = false;
  std::vector<DcOpMode> op_modes;  // the first is the default
  bool external_ref_clock = false;
  bool pdo_oversampling = false;
  bool operator==(const DcDescription&) const = default;
};

}  // namespace syncline
