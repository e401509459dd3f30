// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "support/types.h"

/// The one table of signals: whatever of a run has a value over time. Plots, CSV, statistics and recordings take names,
/// units and values from here.
namespace syncline {

struct CycleSample;
struct SlaveStatus;
struct Snapshot;

enum class Signal : std::uint8_t {
  // of the bus, in every cycle
  kCycle,
  kSendTime,
  kLateness,
  kRoundTrip,
  kReferenceTime,
  kDcmError,
  kDcmErrorFiltered,
  kFrameError,
  kDrift,
  kDcmAdjust,
  kDeviation,
  kDeviationOred,
  kNetworkToSlave,
  kMasterToNetwork,
  kWkcExpected,
  kWkcReceived,
  kFrameLost,
  kFramesLost,
  kFrameLateBy,
  kSkippedCycles,
  kDcInSync,
  kDcmInSync,
  kSlavesSync,
  kMasterSync,
  kMasterState,
  // which slave a cycle told of, and what
  kSlave,
  kSlaveReading,
  kSlaveFollows,
  kSm2Slave,
  kSm2Reading,
  kSm2IntegratorReading,
  // what else a sample has, for recordings
  kFlags,
  kDcmOutputSum,
  kDcmOutputTotal,
  kDcmErrorCode,
  // of the bus, totals
  kLostFrames,
  kLateFrames,
  kLeftOutCycles,
  kWkcErrors,
  kLateSends,
  // of each slave
  kSlaveDeviation,
  kSm2Missed,
  kSm2Integrator,
  kSm2Limit,
  kSm2CyclesToTrip,
  kOutputsExceeded,
  kInputsExceeded,
  kOutputsShiftTooShort,
  kInputsShiftTooShort,
  kClockRate,
  kAlState,
  kProcessDataWatchdog,
  kPdiWatchdog,
  kProcessingUnitErrors,
  kPdiErrors,
  kPortErrors,  // first of sixteen: four kinds for each port, see port_signal()
  // behind them, by the order in which they came: the numbers are those of the series in recordings
  kSyncBase = kPortErrors + 16,  // of the bus, in every cycle
  kPropagationDelay,             // of each slave
  kArrivalPhase,
  kSetpointSlips,
  kWatchList,   // of the bus, in every cycle
  kVariable,    // of each variable of the process image that is watched
  kStampDoubt,  // of the bus, in every cycle
  kStampedBy,
  kCountsAtLeast,  // of each slave
  kExternalError,  // of the bus, in every cycle
};
enum class PortSignal : std::uint8_t { kInvalidFrames, kReceiveErrors, kForwardedErrors, kLostLinks };
inline constexpr std::size_t kPorts = 4, kPortSignals = 4;
static_assert(static_cast<std::size_t>(Signal::kSyncBase) ==
              static_cast<std::size_t>(Signal::kPortErrors) + kPorts * kPortSignals);
inline constexpr std::size_t kSignalCount = static_cast<std::size_t>(Signal::kExternalError) + 1;
[[nodiscard]] constexpr Signal port_signal(std::size_t port, PortSignal kind) {
  return static_cast<Signal>(static_cast<std::size_t>(Signal::kPortErrors) + port * kPortSignals +
                             static_cast<std::size_t>(kind));
}

/// Times, counts and states are whole; rates are not.
using SignalNumber = std::variant<std::int64_t, float>;

/// What a snapshot tells of a slave, and how old that is.
struct SlaveReading {
  Nanoseconds time = 0;  // host clock, when it was read
  double value = 0;
};

struct SignalInfo {
  enum class Scope : std::uint8_t { kBus, kSlave, kVariable };  // kVariable: see WatchLists
  enum class Form : std::uint8_t {
    kCell,      // belongs to a cycle and is not drawn: its number, its times, which slave it told of
    kCycles,    // another value in every cycle
    kReadings,  // read now and then; between two readings nothing is known
    kHeld,      // a count or a state: holds from one reading to the next
    kDerived,   // of a slave, another value in every cycle; made of the bus's when somebody looks at it
    kWatched,   // of a variable, another value in every cycle while it is watched
  };
  enum class Scale : std::uint8_t { kLinear, kSignedLog, kLog, kBand };

  /// By which clock a value is measured that is a time, and with that how far it may be off (signal_quality.h).
  enum class Clock : std::uint8_t {
    kNone,    // none: a count, a state, or what a slave says of itself
    kHost,    // the host's, by the stamps of frames
    kSlaves,  // the clocks in the slaves, which time frames as these pass
    kBoth,    // one against the other
  };

  Signal id;
  std::string_view key;     // CSV column and name in recordings; stays as it is
  std::string_view name;    // for people, English
  std::string_view unit;    // "ns", "ppm", "" for counts and states
  std::string_view source;  // register, object or clock
  std::string_view since;   // for counts: what they count from; "" for momentary values
  Scope scope;
  Form form;
  Scale scale;
  Clock clock;
  /// At most one of the three, by scope and form (readings of single slaves, variables and what is derived have none);
  /// empty where the cycle or the slave has none.
  std::optional<SignalNumber> (*of_cycle)(const CycleSample&);
  std::optional<double> (*of_bus)(const Snapshot&);
  /// `speed_counter_start`: register 0x0930, to which 0x0932 relates.
  std::optional<SlaveReading> (*of_slave)(const Snapshot&, const SlaveStatus&, std::uint16_t speed_counter_start);
};

/// By the number of `Signal`.
[[nodiscard]] std::span<const SignalInfo> signals();
[[nodiscard]] const SignalInfo& info(Signal signal);
/// Null when there is none of this key and scope: a slave's deviation and the largest of all have the same key.
[[nodiscard]] const SignalInfo* find_signal(std::string_view key, SignalInfo::Scope scope);
[[nodiscard]] double as_double(const SignalNumber& number);

}  // namespace syncline
