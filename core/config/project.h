// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/device_description.h"
#include "support/types.h"

namespace syncline {

/// How the master's send time and the reference clock are brought together (EC-Master DCM modes).
enum class DcmMode : std::uint8_t { kOff, kBusShift, kMasterShift };
[[nodiscard]] std::string_view dcm_mode_name(DcmMode mode);  // "bus-shift"
[[nodiscard]] std::optional<DcmMode> dcm_mode_from_name(std::string_view name);

/// Wire-ored SystemTimeDifference against 2^exponent - 1 ns for `settle_time_ms`.
struct SyncWindowSettings {
  bool enabled = false;
  std::uint8_t exponent = 7;             // 127 ns; 1..30
  std::uint32_t settle_time_ms = 1500;   // 0..60000
  bool operator==(const SyncWindowSettings&) const = default;
};

/// Controller of the send phase (EcDcmConfigure's fields under their meanings).
struct DcmSettings {
  DcmMode mode = DcmMode::kBusShift;
  /// Distance from the cyclic frame's send time to SYNC0, ns (nCtlSetVal). Empty: two thirds of the cycle.
  std::optional<Nanoseconds> set_value;
  Nanoseconds in_sync_limit = 4'000;
  std::uint32_t in_sync_settle_time_ms = 1500;
  std::uint32_t start_delay_ms = 0;
  bool operator==(const DcmSettings&) const = default;
};

struct DcMasterSettings {
  bool enabled = true;
  /// Position of the reference clock; empty: first slave with DC enabled.
  std::optional<std::uint16_t> reference_clock;
  bool continuous_propagation_compensation = false;
  bool show_64bit_system_time = false;
  SyncWindowSettings sync_window;
  DcmSettings dcm;
  std::uint32_t burst_total = 10'000;         // frames of the initial drift burst
  std::uint32_t burst_bulk = 12;              // frames a cycle in the burst
  Nanoseconds start_time_safety = 5 * kMillisecond;
  Nanoseconds start_time_grid = 0;            // 0: the cycle
  bool operator==(const DcMasterSettings&) const = default;
};

/// What the master does about slaves that go missing or fall into an error state while the bus runs.
struct RecoverySettings {
  /// Slaves that come back (cable healed, power back) are set up again and led to the state of the bus.
  bool automatic = true;
  /// How often an error state is acknowledged and the state requested again; 0 leaves it to the user.
  std::uint32_t error_tries = 0;          // 0..1000
  /// Goes online with the slaves that are there; the others join when they appear.
  bool start_incomplete = false;
  bool operator==(const RecoverySettings&) const = default;
};

/// Of the thread that runs the cycle on the real clock.
struct RealTimeSettings {
  /// The last part of each wait is spent asking the clock instead of sleeping: earlier wake-ups for processor time.
  Nanoseconds spin = 50 * kMicrosecond;   // 0..1 ms, at most a quarter of the cycle is used
  /// Processor that the thread is bound to.
  std::optional<std::uint16_t> cpu;
  bool operator==(const RealTimeSettings&) const = default;
};

struct MasterSettings {
  std::string name = "Master";
  Nanoseconds cycle_time = kMillisecond;      // 31.25 us .. 100 ms
  std::array<std::uint8_t, 6> destination_mac{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  std::array<std::uint8_t, 6> source_mac{};
  /// Inputs and outputs of a slave share logical addresses, which halves the frame; off for slaves or masters that
  /// cannot do that.
  bool overlap_process_data = true;
  DcMasterSettings dc;
  RecoverySettings recovery;
  RealTimeSettings real_time;
  bool operator==(const MasterSettings&) const = default;
};

/// The user's choice for one SYNC unit; empty optionals follow the operation mode of the ESI.
struct SyncUnitSettings {
  /// Sync Unit Cycle factor: > 0 multiplies, < 0 divides the bus cycle.
  std::optional<int> cycle_factor;
  std::optional<Nanoseconds> user_cycle;      // overrides the factor
  std::optional<Nanoseconds> shift;           // user shift, may be negative
  bool operator==(const SyncUnitSettings&) const = default;
};

struct DcSlaveSettings {
  std::string op_mode;                        // name of the ESI OpMode; "" = DC off (no DC commands)
  SyncUnitSettings sync0, sync1;
  bool potential_reference_clock = false;
  bool operator==(const DcSlaveSettings&) const = default;
};

/// Where a slave hangs: position of the predecessor and its port (0..3 = A..D).
struct PreviousPort {
  std::uint16_t position = 0;
  std::uint8_t port = 1;
  bool operator==(const PreviousPort&) const = default;
};

struct IdentityCheck {
  bool vendor = true, product = true, revision = false, serial = false;
  bool operator==(const IdentityCheck&) const = default;
};

struct SlaveSettings {
  std::string name;
  std::uint16_t station_address = 0;
  std::uint16_t alias = 0;
  DeviceDescription device;
  std::optional<PreviousPort> previous;       // empty on the first slave
  IdentityCheck check;
  std::vector<std::uint16_t> assigned_rx_pdos, assigned_tx_pdos;
  /// Changed mappings of PDOs that are not fixed; others as in the device.
  std::vector<Pdo> changed_pdos;
  DcSlaveSettings dc;
  std::vector<StartupCommand> startup;        // ESI's first, then the user's own
  bool operator==(const SlaveSettings&) const = default;
};

/// Everything the user decides; saved as the project file, turned into a NetworkConfig by compile().
struct Project {
  MasterSettings master;
  std::vector<SlaveSettings> slaves;          // frame order
  bool operator==(const Project&) const = default;
};

/// PDOs that the ESI assigns (Sm attribute) or demands (Mandatory), in its order, without those that exclude each other.
[[nodiscard]] std::vector<std::uint16_t> default_assignment(const DeviceDescription& device, PdoDirection direction);

/// Operation mode `name` ("" = off) with the PDO assignment that the ESI gives this mode, where it gives one.
void select_op_mode(SlaveSettings& slave, std::string_view name);

/// A slave with the ESI's defaults: default PDO assignment, first OpMode (or none), ESI start-up list.
[[nodiscard]] SlaveSettings default_slave(const DeviceDescription& device, std::uint16_t position);

}  // namespace syncline
