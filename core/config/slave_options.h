// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/identity.h"
#include "support/types.h"

/// What a user may set on one slave beside its process data and its clock. An empty optional follows the ESI.
namespace syncline {

struct IdentityCheck {
  bool vendor = true, product = true, revision = false, serial = false;
  std::optional<RevisionCheck> revision_rule = std::nullopt;  // used when `revision`; empty: as the ESI says
  bool alias = false;                                         // 0x0012 must hold SlaveSettings::alias
  /// Explicit device ID (ETG.1020: switch or display of the device); empty: not asked.
  std::optional<std::uint16_t> device_id = std::nullopt;
  bool operator==(const IdentityCheck&) const = default;
};

/// Module plugged into a slot of the device (ETG.5001); slots count from 0 in the order of the ESI.
struct PluggedModule {
  std::uint16_t slot = 0;
  std::uint32_t ident = 0;
  bool operator==(const PluggedModule&) const = default;
};

struct WatchdogSettings {
  std::optional<std::uint16_t> divider;       // 0x0400, in 40 ns, less 2
  std::optional<std::uint16_t> pdi;           // 0x0410, in units of the divider; 0 switches it off
  std::optional<std::uint16_t> process_data;  // 0x0420, in units of the divider; 0 switches it off
  std::optional<bool> outputs;                // watchdog trigger of the outputs' SyncManagers (control byte, bit 6)
  bool operator==(const WatchdogSettings&) const = default;
};

/// ms; empty: ESI Info/StateMachine/Timeout and Info/Mailbox/Timeout.
struct TimeoutSettings {
  std::optional<std::uint32_t> preop, safeop_op, back_to_init, back_to_safeop;  // 1..600000
  std::optional<std::uint32_t> mailbox_request, mailbox_response;               // 1..600000
  bool operator==(const TimeoutSettings&) const = default;
};

struct MailboxSettings {
  std::optional<std::uint16_t> out_size, in_size;  // bytes of the mailbox SyncManagers
  /// The master learns of mail by a bit in the cyclic frames where the device has an FMMU for it; off: it polls.
  bool state_bit = true;
  std::optional<std::uint32_t> poll_time_ms;  // empty: as the dialect's tool writes
  bool operator==(const MailboxSettings&) const = default;
};

/// EoE "set IP parameter" (ETG.1000.6): what is empty is not set. IPv4 addresses as text, "192.168.1.10".
struct EoeSlaveSettings {
  bool enabled = true;  // off: no Ethernet frames to or from this slave
  std::optional<std::array<std::uint8_t, 6>> mac;
  std::string ip, subnet, gateway, dns;
  std::string host_name;  // at most 32 bytes
  bool operator==(const EoeSlaveSettings&) const = default;
};

/// What 0x1C32:01 and 0x1C33:01 are set to (ETG.1020).
enum class SyncTypeChoice : std::uint8_t { kFreeRun, kSmEvent, kSync0, kSync1 };
/// "free-run", "sm-event", "sync0", "sync1".
[[nodiscard]] std::string_view sync_type_name(SyncTypeChoice type);
[[nodiscard]] std::optional<SyncTypeChoice> sync_type_from_name(std::string_view name);

/// Synchronisation objects that are written at start-up; what is empty is left to the device and the operation mode.
struct SyncSettings {
  std::optional<std::uint16_t> error_limit;  // 0x10F1:02; 0 switches the reaction off
  std::optional<SyncTypeChoice> type;        // of outputs and inputs
  std::optional<Nanoseconds> input_shift;    // 0x1C33:03, from the trigger to latching the inputs
  bool operator==(const SyncSettings&) const = default;
};

/// Of a CAN gateway; what is empty is left to the device.
struct CanSettings {
  std::optional<Nanoseconds> cycle;              // a multiple of the bus cycle
  std::optional<std::uint8_t> tx_delay_percent;  // of the CAN cycle, from the SYNC message to the first RxPDO; 0..100
  bool operator==(const CanSettings&) const = default;
};

/// What an output pin of a drive shows on an oscilloscope; functions are those of the device family.
struct OutputPin {
  std::uint8_t pin = 1;  // from 1
  std::uint16_t function = 0;
  bool operator==(const OutputPin&) const = default;
};

/// Name of its own for the variable of one PDO entry.
struct VariableName {
  std::uint16_t pdo = 0;
  std::uint16_t entry = 0;  // place in the PDO's mapping, from 0
  std::string name;
  bool operator==(const VariableName&) const = default;
};

}  // namespace syncline
