// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/device_description.h"
#include "support/clock.h"
#include "support/types.h"

/// A simulated segment as a value; read from a TOML scenario by sim/scenario_loader.
namespace syncline {

struct OscillatorConfig {
  double ppm = 0;                        // against true time, which is the host clock
  double wander_ppm = 0;                 // amplitude of a slow random walk
  Nanoseconds start_offset = 0;          // local time at power-on
};

struct SimDcConfig {
  bool system_time = true;               // has 0x0910.. ; false with receive_times: receive times only
  bool receive_times = true;
  bool is_64bit = true;
};

/// How an ESC reaches its EEPROM.
struct SimSiiConfig {
  Nanoseconds read_time = 0;             // 0x0502.15 stays set for so long; also of a reload
  Nanoseconds write_time = 0;            // of one word
  bool eight_bytes = true;               // a read gives 8 bytes, otherwise 4
};

struct SimSlaveConfig {
  std::string name;
  std::string behaviour;                 // "generic", "servo-y", "drive-c", "can-gateway", "analog-input", "sync-bridge"
  DeviceDescription device;
  std::vector<std::uint8_t> sii_image;   // EEPROM bit for bit; empty: made from `device`
  std::uint16_t alias = 0;
  std::uint32_t serial_no = 0;
  std::uint16_t device_id = 0;           // explicit device identification: what its switches say
  std::uint32_t foe_password = 0;        // 0: none needed
  std::optional<std::uint16_t> parent;   // position; empty on the first slave
  std::uint8_t parent_port = 1;          // port of the parent
  double cable_m = 1.0;                  // to the parent
  OscillatorConfig oscillator;
  SimDcConfig dc;
  SimSiiConfig sii;
  /// "sync-bridge": system time of the network on its other side at a true time; nothing while none is connected.
  std::function<std::optional<Nanoseconds>(Nanoseconds)> external_time;
  std::uint8_t fmmu_count = 8, sync_manager_count = 8;
  std::uint8_t ram_kbytes = 4;           // process data RAM from 0x1000 on
  bool logical_read_write = true;        // the ESC executes LRW
  bool physical_read_write = true;       // ... and APRW, FPRW, BRW
  std::uint32_t processing_delay_ns = 300;   // tP
  std::uint32_t forwarding_delay_ns = 260;   // tF
};

enum class FaultKind : std::uint8_t {
  kLoseFrames,      // count frames from `at`; with a slave: on their way to it, those before have executed them
  kCableBreak,      // slave's cable to its parent from `at` until `until`
  kSlaveOff,        // power lost from `at` until `until`
  kClockStep,       // local clock of slave jumps by `value_ns`
  kRefuseState,     // slave answers a request for `state` with AL status code `code`
  kSlowMailbox,     // slave answers mailbox requests `value_ns` later, from `at` until `until`
  kSlowApplication, // slave's application needs `value_ns` more for each cycle, from `at` until `until`
  kMailboxSilence,  // slave answers no mailbox from `at` until `until`
  kStopApplication, // slave's firmware hangs from `at` until `until`: no answer, no access to its ESC
  kHostStall,       // the host does nothing for `value_ns`; on the virtual clock
  kBitErrors,       // frames received at the slave's `port` are damaged: `count` of them, or all until `until`
};
struct FaultConfig {
  FaultKind kind = FaultKind::kLoseFrames;
  int slave = -1;
  Nanoseconds at = 0;                    // after the bus was switched on
  Nanoseconds until = 0;
  std::uint32_t count = 1;
  Nanoseconds value_ns = 0;
  AlState state = AlState::kNone;
  std::uint16_t code = 0;
  std::uint8_t port = 0;                 // 0..3
};

/// Pulses at a LATCH input of a slave: high for `width`, every `period`, `count` of them.
struct LatchPulses {
  std::uint16_t slave = 0;
  std::uint8_t input = 0;                // 0, 1
  Nanoseconds at = 0;                    // first rising edge, after the bus was switched on
  Nanoseconds width = 0, period = 0;     // width < period
  std::uint32_t count = 1;
};

struct SimConfig {
  std::string name;
  std::uint64_t seed = 1;
  unsigned networks = 1;                 // segments of this kind side by side; see of_network()
  JitterProfile host_jitter;             // of the master's wake-ups, on the virtual clock
  std::vector<SimSlaveConfig> slaves;    // frame order is found from the wiring and must equal this order
  std::vector<FaultConfig> faults;
  std::vector<LatchPulses> latch_pulses;

  /// The segment of network `number` (from 0): like the others, with random processes of its own.
  [[nodiscard]] SimConfig of_network(unsigned number) const {
    auto config = *this;
    config.seed += number * 0x2545'F491'4F6C'DD1DU;
    return config;
  }
};

}  // namespace syncline
