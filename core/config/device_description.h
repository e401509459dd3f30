// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/al_state.h"

/// What an ESI file (ETG.2000) or a slave's SII says about a device: plain values, no XML.
namespace syncline {

struct Identity {
  std::uint32_t vendor_id = 0;
  std::uint32_t product_code = 0;
  std::uint32_t revision_no = 0;
  std::uint32_t serial_no = 0;  // 0 = any
  bool operator==(const Identity&) const = default;
};
[[nodiscard]] std::string to_string(const Identity& identity);  // "0x00000002:0x044c2c52:0x00120000"

enum class PdoDirection : std::uint8_t { kRx, kTx };  // Rx = outputs (master to slave), Tx = inputs

struct PdoEntry {
  std::uint16_t index = 0;      // 0 = padding
  std::uint8_t sub_index = 0;
  std::uint16_t bit_length = 0;
  std::string name;
  std::string data_type;        // ESI name: "UINT", "DINT", "BOOL" ...
  bool operator==(const PdoEntry&) const = default;
};

struct Pdo {
  std::uint16_t index = 0;
  std::string name;
  std::optional<std::uint8_t> sync_manager;  // default assignment by the ESI
  bool fixed = false;                        // mapping cannot be changed
  bool mandatory = false;
  std::vector<std::uint16_t> exclude;
  std::vector<PdoEntry> entries;
  bool operator==(const Pdo&) const = default;
  [[nodiscard]] std::uint32_t bit_length() const;
};

enum class SyncManagerType : std::uint8_t { kUnused = 0, kMailboxOut = 1, kMailboxIn = 2, kOutputs = 3, kInputs = 4 };

struct SyncManagerDescription {
  SyncManagerType type = SyncManagerType::kUnused;
  std::uint16_t start_address = 0;
  std::optional<std::uint16_t> min_size, max_size, default_size;
  std::uint8_t control_byte = 0;
  bool enable = false;
  bool is_virtual = false;
  bool op_only = false;
  bool operator==(const SyncManagerDescription&) const = default;
};

enum class FmmuUse : std::uint8_t { kUnused = 0, kOutputs = 1, kInputs = 2, kMailboxState = 3 };

/// A CoE object written at a transition: from the ESI, or the user's own start-up list.
struct StartupCommand {
  std::vector<Transition> transitions{Transition::kPS};
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::vector<std::uint8_t> data;
  bool complete_access = false;
  bool fixed = false;
  bool enabled = true;
  std::uint32_t timeout_ms = 0;  // 0 = the master's default
  std::string comment;
  bool operator==(const StartupCommand&) const = default;
};

struct CoeDescription {
  bool sdo_info = false;
  bool pdo_assign = false;
  bool pdo_config = false;
  bool pdo_upload = false;
  bool complete_access = false;
  bool segmented_sdo = false;
  std::vector<StartupCommand> init_commands;
  bool operator==(const CoeDescription&) const = default;
};

struct MailboxDescription {
  bool data_link_layer = false;
  bool aoe = false, eoe = false, foe = false, soe = false, voe = false;
  std::optional<CoeDescription> coe;
  std::uint32_t request_timeout_ms = 100;
  std::uint32_t response_timeout_ms = 2000;
  bool operator==(const MailboxDescription&) const = default;
};

/// CycleTimeSync0/1 and ShiftTimeSync0/1 of an OpMode: fixed value (ns) or factor of the Sync Unit
/// Cycle; reference/eni rules in config/compile/dc_times.h.
struct DcTime {
  std::int64_t value_ns = 0;
  std::optional<int> factor;
  bool input = false;  // ShiftTimeSync0@Input
  bool operator==(const DcTime&) const = default;
};

struct OpModeSyncManager {
  std::uint8_t number = 0;
  std::optional<std::uint16_t> sync_type;       // -> 0x1C32/0x1C33:01
  std::vector<std::uint16_t> pdos;              // assignment of that mode, empty = unchanged
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
  bool operator==(const DcDescription&) const = default;
};

/// ESI Info/StateMachine/Timeout, ms; ETG defaults where the ESI is silent.
struct StateTimeouts {
  std::uint32_t preop = 3000;
  std::uint32_t safeop_op = 10000;
  std::uint32_t back_to_init = 5000;
  std::uint32_t back_to_safeop = 200;
  bool operator==(const StateTimeouts&) const = default;
};

struct EepromDescription {
  std::uint32_t byte_size = 2048;
  std::vector<std::uint8_t> config_data;  // first 14 bytes of the SII
  std::vector<std::uint8_t> boot_strap;   // 8 bytes: out start, out length, in start, in length
  bool operator==(const EepromDescription&) const = default;
};

struct ChannelProfile {
  std::uint32_t profile_no = 0;
  std::uint32_t add_info = 0;
  bool operator==(const ChannelProfile&) const = default;
};

struct ObjectEntry {
  std::uint8_t sub_index = 0;
  std::string name;
  std::string data_type;
  std::uint16_t bit_length = 0;
  bool readable = true;
  bool writable = false;
  std::vector<std::uint8_t> default_data;  // little endian; empty = zeros
  bool operator==(const ObjectEntry&) const = default;
};
struct ObjectDescription {
  std::uint16_t index = 0;
  std::string name;
  std::vector<ObjectEntry> entries;  // sub-index ascending
  bool operator==(const ObjectDescription&) const = default;
};

struct DeviceDescription {
  Identity identity;
  std::string vendor_name;
  std::string group_type;
  std::string type;          // ESI Type text, e.g. "EL2002"
  std::string name;          // display name
  std::string physics;       // "YY", "YKKY"
  bool check_revision_low_word = false;
  bool use_lrd_lwr = false;  // Type@UseLrdLwr
  std::vector<FmmuUse> fmmus;
  std::vector<SyncManagerDescription> sync_managers;
  std::vector<Pdo> rx_pdos, tx_pdos;
  std::optional<MailboxDescription> mailbox;
  std::optional<DcDescription> dc;
  StateTimeouts timeouts;
  EepromDescription eeprom;
  std::optional<std::uint16_t> reg_0400, reg_0410, reg_0420;
  std::vector<ChannelProfile> profiles;
  std::vector<ObjectDescription> dictionary;
  std::string source;        // file the description came from, or "SII"
  bool operator==(const DeviceDescription&) const = default;

  /// ESI Eeprom/ConfigData byte 1 bit 0: AL status mirrors AL control, no error acknowledge.
  [[nodiscard]] bool device_emulation() const {
    return eeprom.config_data.size() > 1 && (eeprom.config_data[1] & 0x01) != 0;
  }
  [[nodiscard]] const std::vector<Pdo>& pdos(PdoDirection direction) const {
    return direction == PdoDirection::kRx ? rx_pdos : tx_pdos;
  }
};

}  // namespace syncline
