// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "config/identity.h"
#include "protocol/diagnosis_message_type.h"

/// What slaves tell of themselves, by mailbox and by their counters, and what is seen of cables.
namespace syncline::events {

/// CoE emergency (ETG.1000.6, 5.6.4).
struct Emergency {
  std::uint16_t error_code = 0;
  std::uint8_t error_register = 0;
  std::array<std::uint8_t, 5> data{};
  Identity identity{};  // of the slave, by which families knows its vendor's alarms
};

/// New in its history 0x10F3.
struct DiagnosisTold {
  std::uint32_t code = 0;
  DiagnosisMessageType type = DiagnosisMessageType::kInfo;
  std::uint16_t text_id = 0;     // of the ESI's DiagMessages, 0: none
  std::uint64_t time_stamp = 0;  // ns: DC system time, or since power-on; 0: none
};

/// Since the counters of the port were read last.
struct PortErrors {
  std::uint8_t port = 0;             // 0..3
  std::uint32_t damaged_frames = 0;  // on their way into it
  std::uint32_t lost_links = 0;
  Nanoseconds since = 0;  // when they were read last; 0: nobody knows
};

struct WatchdogExpired {
  enum class Which : std::uint8_t { kProcessData, kPdi };  // PDI: its firmware is silent
  Which which = Which::kProcessData;
  std::uint32_t count = 0;  // since it was read last
};

/// By the slave's own counter (0x1C32:0B and kin): cycles took longer than the cycle time. Once when it begins to rise,
/// and once when it has stopped.
struct LongCycles {
  bool begun = false;
  std::uint32_t count = 0;  // since it was read last
};

/// The slave renews its inputs no longer in every cycle, as it did before, or takes its outputs no longer; or does
/// again.
struct StaleProcessData {
  bool begun = false;
  std::uint32_t stale = 0;  // cycles without new inputs, or whose outputs it left,
  std::uint32_t of = 0;     // of so many
  bool outputs = false;
};

/// Between a port of the event's slave (-1: of the master) and the slave behind it.
struct CableChanged {
  std::uint8_t port = 0;  // 0..3
  int far_slave = -1;
  bool healed = false;  // else nothing comes back over it
};

/// The event's slave is a position on the bus: the device there is none of the configuration's.
struct UnknownSlave {
  Identity identity{};
};

}  // namespace syncline::events
