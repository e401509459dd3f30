// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/dc_settings.h"
#include "config/device_description.h"
#include "config/mailbox_config.h"
#include "config/previous_port.h"
#include "config/register_command.h"
#include "config/slave_options.h"

namespace syncline {

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
  [[nodiscard]] std::vector<std::uint16_t>& assigned_pdos(PdoDirection direction) {
    return direction == PdoDirection::kRx ? assigned_rx_pdos : assigned_tx_pdos;
  }
  [[nodiscard]] const std::vector<std::uint16_t>& assigned_pdos(PdoDirection direction) const {
    return direction == PdoDirection::kRx ? assigned_rx_pdos : assigned_tx_pdos;
  }
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
  /// Messages behind the mailbox header; ESI's first, then the user's own.
  std::vector<MailboxInitCmd> aoe_startup, eoe_startup, foe_startup, voe_startup;
  std::vector<RegisterCommand> register_commands;  // behind those that the compiler makes for the same transition
  /// Names of Sync Units for outputs and inputs; "" = the unnamed one.
  std::string output_unit, input_unit;
  std::vector<VariableName> variable_names;  // by PDO and entry, ascending
  SyncSettings sync;
  CanSettings can;
  std::vector<OutputPin> output_pins;  // pin ascending, one a pin
  bool operator==(const SlaveSettings&) const = default;
};

/// A PDO of the slave's device or modules, with the entries that the user gave it.
[[nodiscard]] Pdo effective_pdo(const SlaveSettings& slave, const Pdo& of_device);

/// PDOs that the ESI assigns (Sm attribute) or demands (Mandatory), in its order, without those that exclude each
/// other.
[[nodiscard]] std::vector<std::uint16_t> default_assignment(const DeviceDescription& device, PdoDirection direction);

/// Operation mode `name` ("" = off) with the PDO assignment that the ESI gives this mode, where it gives one.
void select_op_mode(SlaveSettings& slave, std::string_view name);

/// A slave with the ESI's defaults: default PDO assignment, first OpMode (or none), ESI start-up list.
[[nodiscard]] SlaveSettings default_slave(const DeviceDescription& device, std::uint16_t position);

}  // namespace syncline
