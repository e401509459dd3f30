// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/device_description.h"
#include "config/project.h"
#include "protocol/al_state.h"
#include "protocol/command.h"
#include "support/types.h"

/// What is exported and what is run: the content of an ENI file (ETG.2100) as a value. The ENI
/// writer serialises it, the master executes it.
namespace syncline {

/// ENI Validate@Type: how the answer has to stand to the expected value for the command to be done.
enum class ValidateType : std::uint8_t {
  kEqual,
  kNotEqual,
  kGreaterOrEqual,
  kLessOrEqual,
  kGreater,
  kLess,
  kNone  // kNone: any answer will do
};

struct InitCmdValidate {
  std::vector<std::uint8_t> data;
  std::vector<std::uint8_t> mask;  // empty = compare all
  std::uint32_t timeout_ms = 0;
  ValidateType type = ValidateType::kEqual;
  bool is_signed = false;  // Validate@Signed: of the comparisons by size
  bool operator==(const InitCmdValidate&) const = default;
};

struct InitCmd {
  std::vector<Transition> transitions;
  bool before_slave = false;
  std::string comment;
  bool requires_cycle = false;  // Requires = cycle | (absent)
  Command command = Command::kNop;
  std::uint16_t adp = 0;
  std::uint16_t ado = 0;
  std::uint32_t logical_address = 0;          // instead of adp/ado for LRD, LWR, LRW
  std::vector<std::uint8_t> data;             // bytes in wire order
  std::optional<std::uint16_t> data_length;   // ENI DataLength: that many zero bytes instead of data
  std::optional<std::uint16_t> expected_wkc;  // Cnt
  std::uint32_t retries = 0;
  std::optional<InitCmdValidate> validate;
  std::optional<std::uint32_t> timeout_ms;
  bool operator==(const InitCmd&) const = default;
  [[nodiscard]] std::uint16_t length() const {
    return data_length ? *data_length : static_cast<std::uint16_t>(data.size());
  }
  bool requires_frame = false;  // Requires = frame: not together with others in one frame
};

struct CoeInitCmd {
  StartupCommand command;
  std::uint8_t ccs = 1;  // 1 = download, as all tools write it
  bool operator==(const CoeInitCmd&) const = default;
};

/// Start-up message of AoE, EoE, FoE or VoE: what follows the mailbox header, in wire order.
struct MailboxInitCmd {
  std::vector<Transition> transitions{};
  std::vector<std::uint8_t> data{};
  std::uint32_t timeout_ms = 0;  // 0 = the master's default
  bool enabled = true;
  bool fixed = false;
  std::string comment{};
  bool operator==(const MailboxInitCmd&) const = default;
};

/// Start-up write to an IDN of a SoE drive.
struct SoeInitCmd {
  std::vector<Transition> transitions{};
  std::uint8_t op_code = 3;  // write request
  std::uint8_t drive_no = 0;
  std::uint16_t idn = 0;
  std::uint8_t elements = 0x40;  // which elements of the IDN; 0x40 = its value
  std::uint8_t attribute = 0;
  std::vector<std::uint8_t> data{};
  std::uint32_t timeout_ms = 0;  // 0 = the master's default
  bool enabled = true;
  bool fixed = false;
  std::string comment{};
  bool operator==(const SoeInitCmd&) const = default;
};

struct MailboxChannel {
  std::uint16_t start = 0;
  std::uint16_t length = 0;
  bool short_send = false;  // ENI ShortSend: only the bytes of the message, not the whole buffer
  bool operator==(const MailboxChannel&) const = default;
};

/// ESI Info/Mailbox/Timeout; an ENI has no place for them, so that one that is read has the defaults.
struct MailboxTimeouts {
  std::uint32_t request_ms = 100;    // until the slave has taken a request out of its mailbox
  std::uint32_t response_ms = 2000;  // until its answer is there
  bool operator==(const MailboxTimeouts&) const = default;
};

struct MailboxConfig {
  MailboxChannel send, receive;  // send = master to slave (SM0)
  MailboxTimeouts timeouts;
  std::optional<std::uint32_t> poll_time_ms;
  std::optional<std::uint32_t> status_bit_address;
  std::optional<MailboxChannel> bootstrap_send, bootstrap_receive;
  bool data_link_layer = false;
  bool aoe = false, eoe = false, coe = false, foe = false, soe = false, voe = false;
  std::vector<CoeInitCmd> coe_commands;
  std::vector<ChannelProfile> profiles;
  std::vector<SoeInitCmd> soe_commands{};
  std::vector<MailboxInitCmd> aoe_commands{}, eoe_commands{}, foe_commands{}, voe_commands{};
  std::string aoe_net_id{};   // "1.2.3.4.5.6"; "" = none
  bool eoe_disabled = false;  // EoE@Disabled: the slave could, the configuration does not want it
  bool operator==(const MailboxConfig&) const = default;
};

/// Piece of the process image in bits.
struct ImageRange {
  std::uint32_t bit_start = 0;
  std::uint32_t bit_length = 0;
  std::uint16_t sync_managers = 0;  // ENI Send@Sm0..Sm15 as bits; 0 = not said
  bool operator==(const ImageRange&) const = default;
  /// Some of it lies in these bytes of the image.
  [[nodiscard]] bool touches(std::uint64_t first_byte, std::uint64_t bytes) const {
    return bit_length > 0 && bit_start < (first_byte + bytes) * 8 &&
           std::uint64_t{bit_start} + bit_length > first_byte * 8;
  }
};

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

/// ENI Slave/HotConnect: this slave and those of its group that follow it may be absent, and may be connected anywhere.
struct HotConnectConfig {
  std::string group;
  std::uint16_t member_count = 1;  // slaves of the group, this one being the first
  /// By which it is known: commands to the device at a position, that read and validate its alias (0x0012) or its
  /// explicit device ID.
  std::vector<InitCmd> identify_cmds;
  bool operator==(const HotConnectConfig&) const = default;
  /// When the alias is what they compare.
  [[nodiscard]] std::optional<std::uint16_t> alias() const;
};

/// ENI Info/Identification of another kind than the alias: value and the register it is read from.
struct Identification {
  std::uint16_t ado = 0;
  std::uint32_t value = 0;
  bool operator==(const Identification&) const = default;
};

/// One of the places where a slave may hang, as the ENI names it; the selected one is SlaveConfig::previous.
struct PossiblePort {
  std::uint8_t port = 1;                           // 0..3 = A..D
  std::optional<std::uint16_t> station_address{};  // of the slave in front
  std::optional<std::uint32_t> device_id{};        // deprecated by the schema
  bool operator==(const PossiblePort&) const = default;
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

/// Slave-to-slave copy: bits of this command's inputs that the master puts into its outputs, offsets in the image.
struct CopyInfo {
  std::uint32_t source_bit = 0;
  std::uint32_t destination_bit = 0;
  std::uint32_t bit_size = 0;
  bool operator==(const CopyInfo&) const = default;
};

struct CyclicCmd {
  std::vector<AlState> states;
  std::string comment;
  Command command = Command::kNop;
  std::uint16_t adp = 0;
  std::uint16_t ado = 0;
  std::uint32_t logical_address = 0;
  std::vector<std::uint8_t> data;
  std::optional<std::uint16_t> data_length;
  std::optional<std::uint16_t> expected_wkc;
  std::uint32_t input_offset = 0;
  std::uint32_t output_offset = 0;
  std::vector<CopyInfo> copy_infos;
  bool operator==(const CyclicCmd&) const = default;
  [[nodiscard]] std::uint16_t length() const {
    return data_length ? *data_length : static_cast<std::uint16_t>(data.size());
  }
};

struct CyclicFrame {
  std::vector<CyclicCmd> commands;
  std::string comment{};
  bool operator==(const CyclicFrame&) const = default;
};

struct CyclicTask {
  Nanoseconds cycle_time = kMillisecond;
  std::vector<CyclicFrame> frames;
  std::string comment{};
  std::optional<std::int32_t> priority{};
  std::string task_id{};
  bool cycle_time_given = true;  // false: the ENI says none, cycle_time is the best guess
  bool operator==(const CyclicTask&) const = default;
};

struct Variable {
  std::string name;
  std::string data_type;
  std::string comment;
  std::uint32_t bit_size = 0;
  std::uint32_t bit_offset = 0;
  bool operator==(const Variable&) const = default;
};

struct ProcessImage {
  std::uint32_t input_bytes = 0;
  std::uint32_t output_bytes = 0;
  std::vector<Variable> inputs, outputs;
  /// Bytes from CyclicCmd::input_offset and output_offset to the datagram's data in the image: 0 where a tool counts
  /// the data (EC-Engineer), 10 where it counts datagram headers (ET9000, TwinCAT).
  std::uint32_t command_data_offset = 0;
  bool operator==(const ProcessImage&) const = default;
};

/// ENI Master/EoE: sizes of the switch that the master is between its EoE slaves.
struct EoeSwitchSettings {
  std::uint32_t max_ports = 2;
  std::uint32_t max_frames = 120;
  std::uint32_t max_macs = 100;
  bool operator==(const EoeSwitchSettings&) const = default;
};

struct MasterConfig {
  std::string name;
  std::array<std::uint8_t, 6> destination_mac{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  std::array<std::uint8_t, 6> source_mac{};
  bool eoe = false;  // any EoE slave
  std::optional<std::uint16_t> mailbox_state_count;
  std::vector<InitCmd> init_cmds;
  EoeSwitchSettings eoe_settings;                   // when `eoe`
  std::uint32_t mailbox_state_start = 0x0900'0000;  // logical address of the status bits
  std::uint16_t ether_type = 0x88A4;
  bool operator==(const MasterConfig&) const = default;
};

struct NetworkConfig {
  MasterConfig master;
  std::vector<SlaveConfig> slaves;
  std::vector<CyclicTask> cyclic;  // the first is the base task
  ProcessImage image;
  /// Run-time DC parameters. The ENI carries the mode and whether the window is monitored by its
  /// commands; the numbers (limit, settle time, burst, set value) are the project's, or the
  /// defaults when an ENI is run.
  DcMasterSettings dc;
  /// As `dc`: the project's, or the defaults when an ENI is run.
  RecoverySettings recovery;
  RealTimeSettings real_time;
  bool operator==(const NetworkConfig&) const = default;

  [[nodiscard]] Nanoseconds cycle_time() const { return cyclic.empty() ? kMillisecond : cyclic.front().cycle_time; }
  /// Position of the slave whose DC element says ReferenceClock, if any.
  [[nodiscard]] std::optional<std::uint16_t> reference_clock() const;
  /// First slave of the hot-connect group that this slave belongs to, if any.
  [[nodiscard]] std::optional<std::size_t> hot_connect_head(std::size_t slave) const;
};

}  // namespace syncline
