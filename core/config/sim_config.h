// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/device_description.h"
#include "support/jitter_profile.h"
#include "support/types.h"

/// A simulated segment as a value; read from a TOML scenario by sim/scenario/scenario_loader.
namespace syncline {

/// A clock's rate moves by `ppm` between two times (from one moment to the next when both are the same), and stays
/// there.
struct RateChange {
  Nanoseconds begin = 0, end = 0;
  double ppm = 0;
};

struct OscillatorConfig {
  double ppm = 0;                     // against true time, which is the host clock
  double wander_ppm = 0;              // amplitude of a slow random walk
  Nanoseconds start_offset = 0;       // local time at power-on
  std::vector<RateChange> changes{};  // in true time
};

struct SimDcConfig {
  bool system_time = true;  // has 0x0910.. ; false with receive_times: receive times only
  bool receive_times = true;
  bool is_64bit = true;
  bool sign_of_older_edition = false;  // 0x092C.31: data sheets disagree, see SystemTimeDifference
  double latch_noise_ns = 0;           // receive times of the ports are late by up to this, by chance
};

/// How an ESC reaches its EEPROM.
struct SimSiiConfig {
  Nanoseconds read_time = 0;   // 0x0502.15 stays set for so long; also of a reload
  Nanoseconds write_time = 0;  // of one word
  bool eight_bytes = true;     // a read gives 8 bytes, otherwise 4
};

/// What a metre of cable costs a frame.
inline constexpr double kCableNsPerMetre = 5;

/// How long a frame takes through an ESC: from port 0, through the processing unit (tP), and from the other ports (tF),
/// until it leaves by the next one, ns.
struct EscDelays {
  std::uint32_t processing = 0, forwarding = 0;
};
/// Out by a port with a PHY. The difference, tDiff, is that of most examples of the field.
inline constexpr EscDelays kCableDelays{300, 260};
/// Out by E-bus: what the receive times of couplers and terminals say (155 and 155 + 155 ns behind a coupler; with
/// tDiff 20 ns all hops are the same, with 40 ns those between are 10 ns longer than the last).
inline constexpr EscDelays kEbusDelays{155, 135};

struct SimSlaveConfig {
  std::string name;
  std::string behaviour;  // "generic", "servo-y", "drive-c", "can-gateway", "analog-input", "sync-bridge"
  DeviceDescription device;
  std::vector<std::uint8_t> sii_image;  // EEPROM bit for bit; empty: made from `device`
  std::uint16_t alias = 0;
  std::uint32_t serial_no = 0;
  std::uint16_t device_id = 0;          // explicit device identification: what its switches say
  std::uint32_t foe_password = 0;       // 0: none needed
  std::optional<std::uint16_t> parent;  // position; empty at the one that is wired to the master
  std::uint8_t parent_port = 1;         // port of the parent
  std::uint8_t entry_port = 0;          // own port at which the cable to the parent is
  double cable_m = 1.0;                 // to the parent
  double asymmetry_ns = 0;              // so much longer takes the way out than the way back
  OscillatorConfig oscillator;
  SimDcConfig dc;
  SimSiiConfig sii;
  /// "sync-bridge": system time of the network on its other side at a true time; nothing while none is connected.
  std::function<std::optional<Nanoseconds>(Nanoseconds)> external_time;
  std::uint8_t fmmu_count = 8, sync_manager_count = 8;
  std::uint8_t ram_kbytes = 4;      // process data RAM from 0x1000 on
  bool logical_read_write = true;   // the ESC executes LRW
  bool physical_read_write = true;  // ... and APRW, FPRW, BRW
  std::uint8_t esc_type = 0x11;     // 0x0000
  std::optional<EscDelays> delays;  // whatever the frame leaves by; empty: as a cable or E-bus has them
};

enum class FaultKind : std::uint8_t {
  // The line.
  kLoseFrames,  // count frames, or each with `probability` until `until`; with a slave: on their way to its `port`,
                // all of them until `until` where that is given; those before have executed them
  kBitErrors,   // frames received at the slave's `port` are damaged: `count` of them, all until `until`, or each with
                // `probability`
  kCableBreak,  // slave's cable to its parent from `at` until `until`
  kReversedCable,  // the cables at ports A and `port` of the slave have changed places
  kClosedRing,  // the slave's free `port` leads to the host's second adapter, whose frame comes there `value_ns` after
                // the first adapter has sent
  kForeignFrames,  // count frames that are no EtherCAT, one each `period`; without end until `until` where that is
                   // given
  kSlaveOff,       // power lost from `at` until `until`
  // The host's end of the cable.
  kHoldFrames,   // its card, a driver or a switch passes frames on `value_ns` later, from `at` until `until`
  kHoldAnswers,  // the same with what comes back
  kAdapterOff,   // its adapter is switched off, from `at` until `until`
  // The host; on the virtual clock.
  kHostStall,     // does nothing for `value_ns`
  kCalendarStep,  // its calendar clock, which its stamps of frames are of, is set forwards by `value_ns`
  kClockSlew,     // its clock runs `ppm` off until it is `value_ns` away from where it would have been
  // Clocks.
  kTemperatureRamp,     // a slave's quartz, or without one the host's, moves by `ppm` between `at` and `until`
  kClockStep,           // local clock jumps by `value_ns`
  kIgnoredClockWrites,  // nothing written to 0x0920 to 0x092B takes effect; without a slave: of all
  kOffsetStep,          // somebody adds `value_ns` to 0x0920
  kNoisyDelay,          // somebody writes 0x0928 each `period`, wrong by up to `value_ns`
  kStuckPortTime,       // the receive time of `port` stays what it is
  kWrongStartTime,      // start times written to 0x0990 are taken `value_ns` off
  kSyncLeftRunning,     // SYNC0 runs with the cycle `value_ns`, as a session before left it
  kSilentSync,          // SYNC signals come, but the firmware is not told
  // Firmware.
  kRefuseState,      // slave answers a request for `state` with AL status code `code`
  kMailboxSilence,   // slave answers no mailbox from `at` until `until`
  kSlowMailbox,      // slave answers mailbox requests `value_ns` later, from `at` until `until`
  kSlowApplication,  // slave's application needs `value_ns` more for each cycle, from `at` until `until`
  kStopApplication,  // slave's firmware hangs from `at` until `until`: no answer, no access to its ESC
};
struct FaultConfig {
  FaultKind kind = FaultKind::kLoseFrames;
  int slave = -1;
  Nanoseconds at = 0;  // after the bus was switched on
  Nanoseconds until = 0;
  std::uint32_t count = 1;
  Nanoseconds value_ns = 0;
  AlState state = AlState::kNone;
  std::uint16_t code = 0;
  std::uint8_t port = 0;   // 0..3
  double probability = 0;  // of each frame
  double ppm = 0;
  Nanoseconds period = kMillisecond;
};

/// What the line does all the time.
struct SimBusConfig {
  double loss = 0;                // probability that a frame is lost, anywhere on its way
  double latch_noise_ns = 0;      // see SimDcConfig; of every slave
  double foreign_per_second = 0;  // frames of others, by chance
};

/// Pulses at a LATCH input of a slave: high for `width`, every `period`, `count` of them.
struct LatchPulses {
  std::uint16_t slave = 0;
  std::uint8_t input = 0;             // 0, 1
  Nanoseconds at = 0;                 // first rising edge, after the bus was switched on
  Nanoseconds width = 0, period = 0;  // width < period
  std::uint32_t count = 1;
};

struct SimConfig {
  std::string name;
  std::uint64_t seed = 1;
  unsigned networks = 1;      // segments of this kind side by side; see of_network()
  JitterProfile host_jitter;  // what the host does to times, on the virtual clock
  SimBusConfig bus;
  std::vector<SimSlaveConfig> slaves;  // frame order is found from the wiring and must equal this order
  std::vector<FaultConfig> faults;
  std::vector<LatchPulses> latch_pulses;
  std::vector<std::string> files{};  // what it was read from

  /// The segment of network `number` (from 0): like the others, with random processes of its own.
  [[nodiscard]] SimConfig of_network(unsigned number) const {
    auto config = *this;
    config.seed += number * 0x2545'F491'4F6C'DD1DU;
    return config;
  }
};

}  // namespace syncline
