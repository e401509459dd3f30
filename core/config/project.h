// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/dcm_settings.h"
#include "config/device_description.h"
#include "config/monitor_view.h"
#include "config/slave_options.h"
#include "config/task_settings.h"
#include "support/types.h"

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
  bool operator==(const DcMasterSettings&) const = default;
};

/// What the master does about slaves that go missing or fall into an error state while the bus runs.
struct RecoverySettings {
  /// Slaves that come back (cable healed, power back) are set up again and led to the state of the bus.
  bool automatic = true;
  /// How often an error state is acknowledged and the state requested again; 0 leaves it to the user.
  std::uint32_t error_tries = 0;  // 0..1000
  /// Goes online with the slaves that are there; the others join when they appear.
  bool start_incomplete = false;
  bool operator==(const RecoverySettings&) const = default;
};

/// Of the thread that runs the cycle on the real clock.
struct RealTimeSettings {
  /// So much of the end of each wait is spent at most asking the clock instead of sleeping: earlier wake-ups for
  /// processor time. Used is what the host needs (master/cyclic/spin_budget.h).
  Nanoseconds spin = 50 * kMicrosecond;  // 0..1 ms, at most a quarter of the cycle is used
  /// Processor that the thread is bound to.
  std::optional<std::uint16_t> cpu;
  bool operator==(const RealTimeSettings&) const = default;
};

struct MasterSettings {
  std::string name = "Master";
  Nanoseconds cycle_time = kMillisecond;  // 31.25 us .. 100 ms
  std::array<std::uint8_t, 6> destination_mac{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  std::array<std::uint8_t, 6> source_mac{};
  /// Inputs and outputs of a slave share logical addresses, which halves the frame; off for slaves or masters that
  /// cannot do that.
  bool overlap_process_data = true;
  DcMasterSettings dc;
  RecoverySettings recovery;
  RealTimeSettings real_time;
  ProcessImageSettings image;
  std::vector<TaskSettings> tasks;   // beside the base task, whose cycle is `cycle_time`
  std::vector<SyncUnit> sync_units;  // beside the unnamed one of the base task
  bool operator==(const MasterSettings&) const = default;
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
  bool potential_reference_clock = false;
  bool operator==(const DcSlaveSettings&) const = default;
};

/// Where a slave hangs: position of the predecessor and its port (0..3 = A..D).
struct PreviousPort {
  std::uint16_t position = 0;
  std::uint8_t port = 1;
  bool operator==(const PreviousPort&) const = default;
};

struct SlaveSettings {
  std::string name;
  std::uint16_t station_address = 0;
  std::uint16_t alias = 0;
  DeviceDescription device;
  std::optional<PreviousPort> previous;  // empty on the first slave
  IdentityCheck check;
  /// Name of the hot-connect group that this slave and those behind it form: they may be absent and be plugged in
  /// anywhere, and are known by this slave's alias. Empty: the slave has its place.
  std::string hot_connect;
  std::vector<std::uint16_t> assigned_rx_pdos, assigned_tx_pdos;
  /// Changed mappings of PDOs that are not fixed; others as in the device.
  std::vector<Pdo> changed_pdos;
  DcSlaveSettings dc;
  std::vector<StartupCommand> startup;  // ESI's first, then the user's own
  /// May be missing when the bus starts; like a hot-connect group it is then left out, but it has its place.
  bool optional = false;
  std::vector<PluggedModule> modules;         // slot ascending, one a slot
  std::vector<PdoOversampling> oversampling;  // the user's factors; others as the operation mode says
  WatchdogSettings watchdog;
  TimeoutSettings timeouts;
  MailboxSettings mailbox;
  EoeSlaveSettings eoe;
  std::vector<SoeCommand> soe_startup;  // ESI's first, then the user's own
  std::string ams_net_id;               // AoE, "5.1.2.3.1.1"; "" = none given
  /// Names of Sync Units for outputs and inputs; "" = the unnamed one.
  std::string output_unit, input_unit;
  std::vector<VariableName> variable_names;  // by PDO and entry, ascending
  SyncSettings sync;
  CanSettings can;
  std::vector<OutputPin> output_pins;  // pin ascending, one a pin
  bool operator==(const SlaveSettings&) const = default;
};

/// Everything the user decides; saved as the project file, turned into a NetworkConfig by compile().
struct Project {
  MasterSettings master;
  std::vector<SlaveSettings> slaves;  // frame order
  std::string name;                   // of the network, where a machine has several
  std::vector<MonitorView> views;     // what the monitor draws; nothing that is compiled or runs depends on it
  bool operator==(const Project&) const = default;
};

/// A machine with one EtherCAT network or several, each with a master of its own: what a project file holds.
struct Machine {
  std::string name;
  std::vector<Project> networks;
  bool operator==(const Machine&) const = default;
};

/// PDOs that the ESI assigns (Sm attribute) or demands (Mandatory), in its order, without those that exclude each
/// other.
[[nodiscard]] std::vector<std::uint16_t> default_assignment(const DeviceDescription& device, PdoDirection direction);

/// Operation mode `name` ("" = off) with the PDO assignment that the ESI gives this mode, where it gives one.
void select_op_mode(SlaveSettings& slave, std::string_view name);

/// A slave with the ESI's defaults: default PDO assignment, first OpMode (or none), ESI start-up list.
[[nodiscard]] SlaveSettings default_slave(const DeviceDescription& device, std::uint16_t position);

}  // namespace syncline
