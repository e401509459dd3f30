// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/fault_rules.h"

#include <algorithm>
#include <array>

#include "support/types.h"

namespace syncline::sim {
namespace {

using R = FaultRule;
using S = FaultRule::Subject;

constexpr std::int64_t kDecades = 30 * 365 * 24 * 3600 * kSecond;  // a clock reaches no further
constexpr std::int64_t kHour = 3600 * kSecond, kMinute = 60 * kSecond;
constexpr std::int64_t kCycleMost = kSecond;  // of SYNC0

constexpr std::array kRules{
    FaultRule{"lose-frames", FaultKind::kLoseFrames, S::kAny, R::kUntil | R::kCount | R::kPort | R::kProbability, 0},
    FaultRule{"bit-errors", FaultKind::kBitErrors, S::kSlave, R::kUntil | R::kCount | R::kPort | R::kProbability, 0},
    FaultRule{"cable-break", FaultKind::kCableBreak, S::kSlave, R::kUntil, 0},
    FaultRule{"reversed-cable", FaultKind::kReversedCable, S::kSlave, R::kUntil | R::kPort, R::kPort},
    FaultRule{"closed-ring", FaultKind::kClosedRing, S::kSlave, R::kUntil | R::kPort | R::kValue, R::kPort | R::kValue,
              R::kNothing, 1, kSecond},
    FaultRule{"foreign-frames", FaultKind::kForeignFrames, S::kHost, R::kUntil | R::kCount | R::kPeriod, 0},
    FaultRule{"slave-off", FaultKind::kSlaveOff, S::kSlave, R::kUntil, 0},
    FaultRule{"hold-frames", FaultKind::kHoldFrames, S::kHost, R::kUntil | R::kValue, R::kValue, R::kNothing, 1,
              kSecond},
    FaultRule{"hold-answers", FaultKind::kHoldAnswers, S::kHost, R::kUntil | R::kValue, R::kValue, R::kNothing, 1,
              kSecond},
    FaultRule{"adapter-off", FaultKind::kAdapterOff, S::kHost, R::kUntil, 0},
    FaultRule{"host-stall", FaultKind::kHostStall, S::kHost, R::kValue, R::kValue, R::kNothing, 1, kMinute},
    FaultRule{"calendar-step", FaultKind::kCalendarStep, S::kHost, R::kValue, R::kValue, R::kNothing, -kHour, kHour},
    FaultRule{"clock-slew", FaultKind::kClockSlew, S::kHost, R::kValue | R::kPpm, R::kValue | R::kPpm, R::kNothing,
              -kHour, kHour},
    FaultRule{"temperature-ramp", FaultKind::kTemperatureRamp, S::kAny, R::kUntil | R::kPpm, R::kUntil | R::kPpm,
              R::kClock},
    FaultRule{"clock-step", FaultKind::kClockStep, S::kSlave, R::kValue, R::kValue, R::kClock, -kDecades, kDecades},
    FaultRule{"ignored-clock-writes", FaultKind::kIgnoredClockWrites, S::kAny, R::kUntil, 0, R::kSystemTime},
    FaultRule{"offset-step", FaultKind::kOffsetStep, S::kSlave, R::kValue, R::kValue, R::kSystemTime, -kDecades,
              kDecades},
    FaultRule{"noisy-delay", FaultKind::kNoisyDelay, S::kSlave, R::kUntil | R::kValue | R::kPeriod,
              R::kValue | R::kPeriod, R::kSystemTime, 1, kMillisecond},
    FaultRule{"stuck-port-time", FaultKind::kStuckPortTime, S::kSlave, R::kUntil | R::kPort, R::kPort, R::kClock},
    FaultRule{"wrong-start-time", FaultKind::kWrongStartTime, S::kSlave, R::kUntil | R::kValue, R::kValue,
              R::kSystemTime},
    FaultRule{"sync-left-running", FaultKind::kSyncLeftRunning, S::kSlave, R::kValue, R::kValue, R::kSystemTime,
              kMicrosecond, kCycleMost},
    FaultRule{"silent-sync", FaultKind::kSilentSync, S::kSlave, R::kUntil, 0, R::kSystemTime},
    FaultRule{"refuse-state", FaultKind::kRefuseState, S::kSlave, R::kUntil | R::kState | R::kCode,
              R::kState | R::kCode, R::kFirmware},
    FaultRule{"mailbox-silence", FaultKind::kMailboxSilence, S::kSlave, R::kUntil, 0, R::kMailbox},
    FaultRule{"slow-mailbox", FaultKind::kSlowMailbox, S::kSlave, R::kUntil | R::kValue, R::kValue, R::kMailbox, 1,
              kHour},
    FaultRule{"slow-application", FaultKind::kSlowApplication, S::kSlave, R::kUntil | R::kValue, R::kValue,
              R::kFirmware, 1, kHour},
    FaultRule{"stop-application", FaultKind::kStopApplication, S::kSlave, R::kUntil, 0, R::kFirmware},
};

}  // namespace

std::span<const FaultRule> fault_rules() { return kRules; }

std::vector<std::string_view> host_faults(const SimConfig& config) {
  constexpr std::array kKinds{FaultKind::kHoldFrames, FaultKind::kHoldAnswers, FaultKind::kAdapterOff,
                              FaultKind::kHostStall, FaultKind::kCalendarStep};
  std::vector<std::string_view> names;
  for (const auto& rule : kRules) {
    const bool of_host = std::ranges::find(kKinds, rule.kind) != kKinds.end();
    if (of_host && std::ranges::find(config.faults, rule.kind, &FaultConfig::kind) != config.faults.end())
      names.push_back(rule.name);
  }
  return names;
}

std::string_view name_of(FaultRule::Key key) {
  switch (key) {
    case R::kUntil:
      return "until_ms";
    case R::kCount:
      return "count";
    case R::kPort:
      return "port";
    case R::kValue:
      return "value_ns";
    case R::kState:
      return "state";
    case R::kCode:
      return "code";
    case R::kProbability:
      return "probability";
    case R::kPpm:
      return "ppm";
    case R::kPeriod:
      return "period_ms";
  }
  return "";
}

}  // namespace syncline::sim
