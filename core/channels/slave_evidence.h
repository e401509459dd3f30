// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "support/types.h"

/// What is read of each slave in turn while the bus runs, besides its deviation: counts since going online, by
/// differences of its counters, each with the host time of its newest reading.
namespace syncline {

/// A count of something. `time` 0: never read.
struct EvidenceCount {
  std::uint32_t total = 0;
  bool at_least = false;  // the counter stood at its end stop, or was cleared between two readings
  Nanoseconds time = 0;
  [[nodiscard]] bool valid() const { return time != 0; }
  bool operator==(const EvidenceCount&) const = default;
};

/// Error counters of an ESC port (0x0300 to 0x0313; ESC data sheet II, 2.9).
struct PortErrors {
  std::uint32_t invalid_frames = 0;    // 0x0300 + 2 p: CRC errors and alignment
  std::uint32_t receive_errors = 0;    // 0x0301 + 2 p: symbol errors of the PHY, also outside frames
  std::uint32_t forwarded_errors = 0;  // 0x0308 + p: damaged in front of this slave, and marked by who saw it first
  std::uint32_t lost_links = 0;        // 0x0310 + p
  bool at_least = false;
  bool operator==(const PortErrors&) const = default;
};

/// 0x1C32 or 0x1C33 of a slave (ETG.1020).
struct SyncObjectCounts {
  EvidenceCount exceeded;           // cycles that took longer than the cycle time
  std::uint32_t by_frames = 0;      // of these, without SYNC0: no more than frames that came too soon after others
  EvidenceCount shift_too_short;    // 0D: outputs too late for SYNC0, or SYNC1 too close behind it
  bool sync_error = false;          // 20, at its newest reading
  Nanoseconds sync_error_time = 0;  // host clock of that; 0: never read
  bool operator==(const SyncObjectCounts&) const = default;
};

/// What became of a slave's SYNC0 when it was switched on: read back from 0x0984 and 0x0990.
struct Sync0Start {
  Nanoseconds time = 0;     // host clock of the newest reading; 0: never
  bool never = false;       // its start time had passed: it will not come
  std::int32_t off_ns = 0;  // later than the configuration asks for, within half of its period either way
  /// More than clocks and registers make of themselves while they settle.
  static constexpr std::int32_t kInPlace = 10'000;  // ns
  [[nodiscard]] bool misplaced() const { return time != 0 && !never && (off_ns > kInPlace || off_ns < -kInPlace); }
  bool operator==(const Sync0Start&) const = default;
};

struct SlaveEvidence {
  std::array<PortErrors, 4> ports{};
  EvidenceCount processing_unit_errors;       // 0x030C, read with the ports
  EvidenceCount pdi_errors;                   // 0x030D, the same
  Nanoseconds ports_time = 0;                 // of the newest reading of the ports; 0: never
  EvidenceCount process_data_watchdog;        // 0x0442: expirations
  EvidenceCount pdi_watchdog;                 // 0x0443: the firmware was silent for so long (0x0410)
  bool pdi_silent = false;                    // 0x0110 bit 1 clear: and is still; read of who was silent once
  std::int16_t speed_counter_difference = 0;  // 0x0932: how much this clock is slowed or sped up
  Nanoseconds speed_counter_time = 0;
  SyncObjectCounts outputs, inputs;    // 0x1C32, 0x1C33
  std::uint32_t calc_and_copy_ns = 0;  // 0x1C32:06, what the slave needs from its outputs to SYNC0; 0: not told
  Sync0Start sync0;
  std::uint32_t mailbox_silences = 0;  // in a row: requests without an answer
  bool operator==(const SlaveEvidence&) const = default;
};

}  // namespace syncline
