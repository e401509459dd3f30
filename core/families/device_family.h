// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/coe.h"
#include "support/types.h"

/// What is known of a product line beyond its ESI files. Values only; each group of them names its source. Where an ESI
/// says something else of an object, the ESI is right.
namespace syncline::families {

inline constexpr std::uint16_t kOutputSync = 0x1C32;              // ETG.1020, "Output SyncManager parameter"
inline constexpr std::uint16_t kInputSync = 0x1C33;               // ETG.1020, "Input SyncManager parameter"
inline constexpr coe::ObjectAddress kSyncErrorLimit{0x10F1, 2};   // ETG.1020, "Sync error counter limit"
inline constexpr coe::ObjectAddress kErrorCode{0x603F, 0};        // CiA 402
inline constexpr coe::ObjectAddress kModeOfOperation{0x6060, 0};  // CiA 402; 0x800 more for each further axis

/// Sub-indices of 0x1C32 and 0x1C33 that count; 0: the device has none. ETG.1020 has them at 0x0B, 0x0C and 0x0D; the
/// older layout, still in the field, has exceeded cycles at 0x0B and missed events at 0x0C. All are 16 bit and wrap.
struct SyncCounters {
  std::uint8_t missed = 0x0B;          // SM events that did not come between two SYNC0
  std::uint8_t cycle_exceeded = 0x0C;  // local cycles that were not over when the next one had to begin
  std::uint8_t shift_too_short =
      0x0D;  // outputs that came less than calc and copy in front of SYNC0, or SYNC0 to SYNC1 too short
  /// Back to 0 as soon as the device leaves OP; otherwise they can be read until the next OP.
  bool end_with_op = false;
  std::string_view source{};
  bool operator==(const SyncCounters&) const = default;
};

/// SYNC0 cycles that the device takes, ns.
struct CycleLimits {
  Nanoseconds step = 1;                   // the cycle is a multiple of it, else the device refuses SAFEOP
  Nanoseconds full_step = 1;              // a multiple of `step`: other cycles are taken, but ...
  std::string_view otherwise{};           // ... this is what is lost with them
  Nanoseconds shortest = 0, longest = 0;  // 0: not known
  std::string_view source{};
};

/// Object 0x10F1:02. The device adds 3 for a missed event, takes 1 away for a good one (not below 0), and leaves OP
/// when it gets to the limit; 0 switches that off.
struct ErrorLimit {
  std::uint16_t usual = 4;                // after power-on
  std::uint16_t largest = 0xFFFF;         // a download of more is refused
  std::uint16_t al_status_code = 0x001A;  // with which the device leaves OP
  std::uint16_t error_code = 0;           // in 0x603F then; 0: none known
  std::string_view source{};
};

/// Alarm by its number in 0x603F and in emergencies, with the name that the vendor's manuals and displays have.
struct Alarm {
  std::uint16_t error_code = 0;
  std::string_view name{};  // "A.A12"; empty: the vendor has none
  std::string_view text{};
};

struct Alarms {
  std::span<const Alarm> list{};
  std::string_view source{};
};

/// Values of 0x1C32:01 and 0x1C33:01 (ETG.1020): 0 free run, 1 own SM event, 2 SYNC0, 3 SYNC1, 0x22 SM2 event.
struct SyncTypes {
  std::span<const std::uint16_t> outputs{}, inputs{};  // those that the device takes
  std::uint16_t usual_outputs = 0, usual_inputs = 0;   // after power-on
  bool writable = false;                               // otherwise a download is refused, which ends the start-up
  bool follow_dc = false;                              // the SYNC signals set them; otherwise the master has to
  std::string_view source{};
};

/// A mode of operation (0x6060) that is nothing without SYNC0.
struct ModeNeedsDc {
  std::int8_t mode = 0;
  bool refused = false;    // the drive does not execute it; otherwise it moves badly
  std::string_view why{};  // one sentence
};

struct ModesNeedDc {
  std::span<const ModeNeedsDc> list{};
  std::string_view source{};
};

/// PDO entries of one direction, padding not counted.
struct ObjectLimit {
  unsigned per_direction = 0;  // 0: not known
  std::string_view source{};
};

/// One bit of a status object.
struct StatusBit {
  std::uint8_t bit = 0;
  bool wanted = false;                        // what a synchronised device shows
  std::string_view when_set{}, when_clear{};  // short sentences
};

struct StatusObject {
  coe::ObjectAddress object{};
  std::string_view name{};
  std::span<const StatusBit> bits{};
  std::string_view source{};
};

/// What an output pin can show on an oscilloscope.
struct PinFunction {
  std::uint16_t value = 0;
  std::string_view word{};   // "servo-period"
  std::string_view shows{};  // "the start of the servo period"
};

/// Object with one sub-index for each output pin; the function is in the first two of its bytes.
struct PinObject {
  std::uint16_t index = 0;
  std::uint8_t pins = 0;
  std::uint8_t bytes = 2;  // of an entry
  std::span<const PinFunction> functions{};
  std::string_view source{};
};

/// Gateway to a CAN segment whose cycle is a multiple of the bus cycle.
struct CanGateway {
  coe::ObjectAddress can_cycle{};     // u32, ns; n = this by `told_cycle`, 1 when one of them is 0
  coe::ObjectAddress told_cycle{};    // u32, ns: bus cycle, which the start-up list has to tell without SYNC0
  coe::ObjectAddress tx_pdo_delay{};  // u8, % of the CAN cycle, from the SYNC message to the first synchronous RxPDO
  coe::ObjectAddress input_shift{};   // u32, ns, from the start of the bus cycle to taking the inputs
  std::uint16_t node_states = 0;      // one sub-index a node
  std::uint8_t node_late = 0;         // state of a node whose synchronous TxPDO was not there in time, for one cycle
  Nanoseconds sync1_jitter = 0;       // of the SYNC message when SYNC1 releases it
  std::string_view source{};
};

/// Worst case of the device's own times, ns, where they are known without asking it (0x1C32:06 and :09).
struct LocalTimes {
  Nanoseconds calc_and_copy = 0, delay = 0;
  std::string_view source{};
};

/// How a device is known: by its vendor and a range of product codes, or by the beginning of its type's name.
struct Match {
  std::uint32_t vendor_id = 0;
  std::uint32_t first_product = 0, last_product = 0xFFFF'FFFF;
  std::string_view type{};  // beginning of ESI Type, for products outside of the range; "" = none
};

struct Family {
  std::string_view id{};       // "yaskawa-sigma-5"; stable
  std::string_view name{};     // in sentences: "Yaskawa Sigma-5 drives take ..."
  std::string_view devices{};  // plural noun: "drives", "gateways"
  Match match{};
  std::string_view behaviour{};  // of the simulated device that stands for it; "" = "generic"
  std::optional<SyncCounters> counters{};
  std::optional<CycleLimits> cycle{};
  std::optional<ErrorLimit> error_limit{};
  std::optional<LocalTimes> times{};
  std::optional<StatusObject> status{};
  std::optional<PinObject> pins{};
  std::optional<CanGateway> gateway{};
  Alarms alarms{};
  SyncTypes sync_types{};
  ModesNeedDc modes_need_dc{};
  ObjectLimit objects{};
};

}  // namespace syncline::families
