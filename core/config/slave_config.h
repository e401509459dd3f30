// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/hot_connect.h"
#include "config/identity.h"
#include "config/init_cmd.h"
#include "config/mailbox_config.h"
#include "config/pdo_description.h"
#include "config/previous_port.h"
#include "config/process_image.h"
#include "config/state_timeouts.h"
#include "config/sync_manager_description.h"

/// One slave as it is exported and run (ETG.2100, Slave).
namespace syncline {

struct ConfiguredSyncManager {
  std::uint8_t number = 0;
  SyncManagerDescription description;
  std::vector<std::uint16_t> pdos;          // assigned
  std::optional<std::uint32_t> watchdog{};  // ENI Sm*/Watchdog
  bool operator==(const ConfiguredSyncManager&) const = default;
};

struct ConfiguredPdo {
  PdoDirection direction = PdoDirection::kRx;
  Pdo pdo;  // sync_manager set when assigned, empty when not
  bool operator==(const ConfiguredPdo&) const = default;
};

/// ENI Slave/DC, ns.
struct SlaveDcConfig {
  bool potential_reference_clock = false;
  bool reference_clock = false;
  std::int64_t cycle_time0 = 0;
  std::int64_t cycle_time1 = 0;  // value of 0x09A4
  std::int64_t shift_time = 0;
  std::uint16_t assign_activate = 0;  // not in the element; found in the 0x0980 command
  bool operator==(const SlaveDcConfig&) const = default;
};

/// ENI Info/Identification of another kind than the alias: value and the register it is read from.
struct Identification {
  std::uint16_t ado = 0;
  std::uint32_t value = 0;
  bool operator==(const Identification&) const = default;
};

struct SlaveConfig {
  std::string name;
  std::uint16_t station_address = 0;
  std::uint16_t auto_increment_address = 0;
  std::uint16_t alias = 0;
  std::string physics;
  Identity identity;
  std::optional<ImageRange> send, receive;  // send = outputs
  std::vector<ConfiguredSyncManager> sync_managers;
  std::vector<ConfiguredPdo> pdos;  // all TxPdo first, then all RxPdo
  std::optional<MailboxConfig> mailbox;
  std::vector<InitCmd> init_cmds;
  std::optional<PreviousPort> previous;
  std::optional<HotConnectConfig> hot_connect;
  /// Present when DC is used.
  std::optional<SlaveDcConfig> dc;
  StateTimeouts timeouts;
  std::string product_revision{};                  // ENI ProductRevision, "EL2008-0000-0018"; "" = not written
  std::optional<Identification> identification{};  // other than `alias`
  std::vector<PossiblePort> other_ports{};         // PreviousPort that are not selected
  /// Where a tool writes one Send or Recv for each SyncManager: those pieces; `send` and `receive` span them.
  std::vector<ImageRange> send_parts{}, receive_parts{};
  bool operator==(const SlaveConfig&) const = default;
};

}  // namespace syncline
