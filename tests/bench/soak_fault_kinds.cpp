// SPDX-License-Identifier: Apache-2.0
#include "bench/soak_fault_kinds.h"

namespace syncline::bench {
namespace {

std::vector<Signal> of_ports(std::vector<PortSignal> kinds) {
  std::vector<Signal> all;
  for (std::size_t port = 0; port < kPorts; ++port) {
    for (const auto kind : kinds) all.push_back(port_signal(port, kind));
  }
  return all;
}

std::vector<Signal> operator+(std::vector<Signal> some, const std::vector<Signal>& more) {
  some.insert(some.end(), more.begin(), more.end());
  return some;
}

/// Who gets no outputs for a few cycles counts it, and a drive falls by it.
const std::vector<Signal> kWithoutOutputs{Signal::kSm2Missed, Signal::kSetpointSlips, Signal::kAlState};
const std::vector<Signal> kDeviations{Signal::kDeviation, Signal::kSlaveDeviation};
/// Who is away, and who is behind it and gets no outputs; their clocks settle anew when they are back, and the
/// master with them where it was who leads.
std::vector<Signal> away() {
  return std::vector{Signal::kSm2Missed, Signal::kWkcErrors, Signal::kAlState, Signal::kProcessDataWatchdog,
                     Signal::kDcmErrorFiltered} +
         kDeviations + of_ports({PortSignal::kLostLinks});
}
/// The machine that was never in OP.
const std::vector<Signal> kStayedDown{Signal::kAlState};
/// What the firmware tells by its mailbox.
const std::vector<Signal> kToldByMailbox{Signal::kOutputsExceeded, Signal::kInputsExceeded,
                                         Signal::kOutputsShiftTooShort, Signal::kInputsShiftTooShort};

std::vector<SoakFaultKind> line_kinds() {
  return {
      {.name = "lost frames",
       .kind = FaultKind::kLoseFrames,
       .victims = {},
       .most_count = 4,
       .events = {kind_of<events::FramesLost>},
       .findings = {code::kFramesLost},
       .also = {code::kMissedByLostFrames, code::kSlaveFellByMisses, code::kFramesLostInFront},
       .shows = {Signal::kLostFrames},
       .may_show = kWithoutOutputs},
      {.name = "lost on a cable",
       .kind = FaultKind::kLoseFrames,
       .victims = {1, 2, 3, 4, 5},
       .most_count = 4,
       .events = {kind_of<events::FramesLost>},
       .findings = {code::kFramesLost},
       .also = {code::kMissedByLostFrames, code::kSlaveFellByMisses, code::kFramesLostInFront, code::kFramesLostBehind},
       .shows = {Signal::kLostFrames},
       .may_show = kWithoutOutputs},
      {.name = "damaged frames",
       .kind = FaultKind::kBitErrors,
       .victims = {0, 1, 2, 3, 4, 5},
       .most_count = 4,
       .events = {kind_of<events::PortErrors>},
       .findings = {code::kPortErrors, code::kFramesLostByNoise},
       .also = {code::kMissedByLostFrames, code::kSlaveFellByMisses},
       .shows = of_ports({PortSignal::kInvalidFrames, PortSignal::kReceiveErrors}),
       .may_show = kWithoutOutputs + std::vector{Signal::kLostFrames} + of_ports({PortSignal::kForwardedErrors})},
      {.name = "cable break",
       .kind = FaultKind::kCableBreak,
       .victims = {1, 2, 3, 4, 5},
       .shortest = 2 * kSecond,
       .longest = 20 * kSecond,
       .events = {kind_of<events::HotConnect>},
       .findings = {code::kSlaveWasAbsent},
       .also = {code::kSlaveWasAbsent, code::kLinkLost, code::kFramesWayChanged},
       .shows = {Signal::kAlState},
       .may_show = away()},
      {.name = "power off",
       .kind = FaultKind::kSlaveOff,
       .victims = {0, 1, 2, 3, 4, 5},
       .shortest = 2 * kSecond,
       .longest = 20 * kSecond,
       .events = {kind_of<events::HotConnect>},
       .findings = {code::kSlaveWasAbsent},
       .also = {code::kSlaveWasAbsent, code::kLinkLost, code::kFramesWayChanged},
       .shows = {Signal::kAlState},
       .may_show = away() + std::vector{Signal::kLostFrames}},
      {.name = "foreign frames",
       .kind = FaultKind::kForeignFrames,
       .victims = {},
       .most_count = 100,
       .findings = {code::kForeignFrames},
       .shows = {Signal::kProcessingUnitErrors},
       .may_show = of_ports({PortSignal::kForwardedErrors})},
      {.name = "reversed cable",
       .kind = FaultKind::kReversedCable,
       .victims = {2, 3},
       .port = 1,
       .while_down = true,
       .events = {kind_of<events::DelayFinding>, kind_of<events::Failure>},
       .also = {code::kSlaveAbsent},
       .shows = kStayedDown,
       .may_show = kStayedDown},
      {.name = "closed ring",
       .kind = FaultKind::kClosedRing,
       .victims = {5},
       .least = 100,
       .most = 5'000,
       .port = 1,
       .while_down = true,
       .events = {kind_of<events::DelayFinding>, kind_of<events::Failure>}},
  };
}

std::vector<SoakFaultKind> host_kinds() {
  return {
      {.name = "host stall",
       .kind = FaultKind::kHostStall,
       .victims = {},
       .least = 3 * kMillisecond,
       .most = 30 * kMillisecond,
       .in_cycles = true,
       .findings = {code::kHostStalled},
       .also = {code::kMissedByHost, code::kSlaveFellByMisses, code::kMasterLostLock, code::kExceededByHost},
       .shows = {Signal::kLeftOutCycles},
       .may_show =
           kWithoutOutputs + std::vector{Signal::kLateSends, Signal::kOutputsShiftTooShort, Signal::kOutputsExceeded}},
      {.name = "held frames",
       .victims = {},
       .least = 15 * kMicrosecond,
       .most = 900 * kMicrosecond,
       .in_cycles = true,
       .most_count = 60,
       .harmless = true,
       .held_up = true,
       .also = {code::kMissedByHeldFrames, code::kMissedByLateFrames, code::kReferenceWrittenLate, code::kFramesLate,
                code::kSlaveFellByMisses, code::kExceededByHost},
       .may_show = kWithoutOutputs + kDeviations +
                   std::vector{Signal::kLateFrames, Signal::kLateSends, Signal::kDcmErrorFiltered}},
      {.name = "clock slew",
       .kind = FaultKind::kClockSlew,
       .victims = {},
       .least = 150 * kMicrosecond,
       .most = 300 * kMicrosecond,
       .ppm = 50,
       .events = {kind_of<events::DcmError>, kind_of<events::MasterOutOfSync>},
       .findings = {code::kMasterLostLock, code::kDcmError, code::kWindowLeft},
       .also = {code::kSlaveLeftWindow, code::kJitterReachesClock, code::kExternalClockLeft,
                code::kExternalClockNotMet},
       .shows = std::vector{Signal::kDcmErrorFiltered} + kDeviations},
      {.name = "host warms up",
       .kind = FaultKind::kTemperatureRamp,
       .victims = {},
       .shortest = 60 * kSecond,
       .longest = 150 * kSecond,
       .ppm = 5,
       .harmless = true},
  };
}

std::vector<SoakFaultKind> clock_kinds() {
  return {
      {.name = "slave warms up",
       .kind = FaultKind::kTemperatureRamp,
       .victims = {0, 1, 2, 3, 4, 5},
       .shortest = 60 * kSecond,
       .longest = 150 * kSecond,
       .ppm = 10,
       .harmless = true},
      {.name = "clock step",
       .kind = FaultKind::kClockStep,
       .victims = {1, 2, 3, 4},
       .of_clock = true,
       .least = kMicrosecond,
       .most = kMillisecond,
       .either_sign = true,
       .events = {kind_of<events::SlavesOutOfSync>, kind_of<events::SlavesSyncUnknown>},
       .findings = {code::kSlaveLeftWindow, code::kMissedByMovedClock},
       .also = {code::kWindowLeft, code::kShiftTooShort, code::kSlaveFellByMisses, code::kSlaveFellByMovedClock},
       .shows = kDeviations,
       .may_show = kWithoutOutputs + std::vector{Signal::kOutputsShiftTooShort, Signal::kOutputsExceeded}},
      {.name = "reference steps",
       .kind = FaultKind::kClockStep,
       .victims = {},
       .of_reference = true,
       .least = kMicrosecond,
       .most = kMillisecond,
       .either_sign = true,
       .events = {kind_of<events::SlavesOutOfSync>, kind_of<events::SlavesSyncUnknown>, kind_of<events::DcmError>,
                  kind_of<events::MasterOutOfSync>},
       .findings = {code::kWindowLeft},
       .also = {code::kMissedByMovedClock, code::kMasterLostLock, code::kShiftTooShort, code::kSlaveFellByMisses,
                code::kSlaveFellByMovedClock, code::kExternalClockLeft, code::kExternalClockNotMet},
       .shows = kDeviations,
       .may_show = kWithoutOutputs + kDeviations +
                   std::vector{Signal::kOutputsShiftTooShort, Signal::kOutputsExceeded, Signal::kDcmErrorFiltered,
                               Signal::kLateSends}},
      {.name = "offset step",
       .kind = FaultKind::kOffsetStep,
       .victims = {1, 2, 3, 4},
       .of_clock = true,
       .least = 2 * kMicrosecond,
       .most = 500 * kMicrosecond,
       .either_sign = true,
       .events = {kind_of<events::SlavesOutOfSync>, kind_of<events::SlavesSyncUnknown>},
       .findings = {code::kSlaveLeftWindow, code::kMissedByMovedClock},
       .also = {code::kWindowLeft, code::kShiftTooShort, code::kSlaveFellByMisses, code::kSlaveFellByMovedClock},
       .shows = kDeviations,
       .may_show = kWithoutOutputs + std::vector{Signal::kOutputsShiftTooShort, Signal::kOutputsExceeded}},
      {.name = "noisy delay",
       .kind = FaultKind::kNoisyDelay,
       .victims = {1, 2, 3, 4},
       .of_clock = true,
       .shortest = 5 * kSecond,
       .longest = 10 * kSecond,
       .least = 5 * kMicrosecond,
       .most = 20 * kMicrosecond,
       .period = 10 * kMillisecond,
       .events = {kind_of<events::SlavesOutOfSync>, kind_of<events::SlavesSyncUnknown>},
       .findings = {code::kSlaveLeftWindow},
       .also = {code::kWindowLeft},
       .shows = kDeviations},
      {.name = "ignored clock writes",
       .kind = FaultKind::kIgnoredClockWrites,
       .victims = {1, 2, 3},
       .of_clock = true,
       .while_down = true,
       .switched_on_anew = true,
       .events = {kind_of<events::SlavesOutOfSync>, kind_of<events::SlavesSyncUnknown>, kind_of<events::Failure>},
       .findings = {code::kSlaveLeftWindow, code::kSlavesOutOfSync, code::kSlavesSyncUnknown},
       .also = {code::kSlaveBehind, code::kMasterNotLocked},
       .shows = kStayedDown + kDeviations,
       .may_show = kStayedDown},
      {.name = "stuck port time",
       .kind = FaultKind::kStuckPortTime,
       .victims = {1, 2, 3},
       .of_clock = true,
       .port = 1,
       .while_down = true,
       .events = {kind_of<events::DelayFinding>, kind_of<events::Failure>},
       .findings = {code::kDelayNotMeasured},
       .also = {code::kDelayNotMeasured}},
      {.name = "wrong start time",
       .kind = FaultKind::kWrongStartTime,
       .victims = {1, 2},
       .of_clock = true,
       .least = 200 * kMicrosecond,
       .most = 800 * kMicrosecond,
       .in_cycles = true,
       .while_down = true,
       .findings = {code::kSync0Misplaced},
       .also = {code::kSlaveFellByMisses, code::kSlaveFell},
       .may_show = {Signal::kOutputsShiftTooShort, Signal::kSm2Missed, Signal::kAlState}},
      {.name = "SYNC0 left running",
       .kind = FaultKind::kSyncLeftRunning,
       .victims = {1, 2, 3},
       .of_clock = true,
       .least = 2 * kMillisecond,
       .most = 4 * kMillisecond,
       .in_cycles = true,
       .while_down = true,
       .harmless = true},
      {.name = "SYNC unheard",
       .kind = FaultKind::kSilentSync,
       .victims = {1, 2},
       .of_clock = true,
       .shortest = kSecond,
       .longest = 5 * kSecond,
       .events = {kind_of<events::AlStatusError>},
       .findings = {code::kSlaveFellByItself},
       .also = {code::kSlaveHadFallen},
       .shows = {Signal::kAlState}},
  };
}

std::vector<SoakFaultKind> firmware_kinds() {
  return {
      {.name = "refused state",
       .kind = FaultKind::kRefuseState,
       .victims = {1, 2, 3, 4},
       .state = AlState::kSafeop,
       .code = 0x001E,
       .while_down = true,
       .events = {kind_of<events::AlStatusError>, kind_of<events::Failure>},
       .findings = {code::kSlaveBehind, code::kSlaveFell, code::kSlaveRefused},
       .shows = kStayedDown,
       .may_show = kStayedDown},
      {.name = "mailbox silent",
       .kind = FaultKind::kMailboxSilence,
       .victims = {1, 2, 3, 4},
       .shortest = 20 * kSecond,
       .longest = 40 * kSecond,
       .findings = {code::kMailboxSilent},
       .gaps = kToldByMailbox},
      {.name = "mailbox slow",
       .kind = FaultKind::kSlowMailbox,
       .victims = {1, 2, 3, 4},
       .shortest = 30 * kSecond,
       .longest = 60 * kSecond,
       .least = 2'200 * kMillisecond,
       .most = 4 * kSecond,
       .findings = {code::kMailboxSilent},
       .gaps = kToldByMailbox},
      {.name = "firmware slow",
       .kind = FaultKind::kSlowApplication,
       .victims = {1, 2, 3},
       .with_sync0 = true,
       .shortest = 2 * kSecond,
       .longest = 5 * kSecond,
       .least = 1'500 * kMicrosecond,
       .most = 8 * kMillisecond,
       .in_cycles = true,
       .findings = {code::kFirmwareSlow},
       .shows = {Signal::kOutputsExceeded}},
      {.name = "firmware slow, without SYNC0",
       .kind = FaultKind::kSlowApplication,
       .victims = {1, 3, 4, 5},
       .by_itself = true,
       .shortest = 4 * kSecond,
       .longest = 8 * kSecond,
       .least = 1'500 * kMicrosecond,
       .most = 8 * kMillisecond,
       .in_cycles = true,
       .findings = {code::kGatewayCycleExceeded, code::kInputsLate, code::kOutputsLate},
       .may_show = {Signal::kOutputsExceeded}},
      {.name = "firmware hangs",
       .kind = FaultKind::kStopApplication,
       .victims = {1, 2, 3, 4},
       .shortest = 300 * kMillisecond,
       .longest = 3 * kSecond,
       .events = {kind_of<events::WatchdogExpired>},
       .findings = {code::kFirmwareHung},
       .also = {code::kMailboxSilent, code::kSlaveFellByHang},
       .shows = {Signal::kPdiWatchdog},
       .may_show = {Signal::kAlState, Signal::kSm2Missed}},
  };
}

}  // namespace

std::span<const SoakFaultKind> soak_fault_kinds() {
  static const auto all = [] {
    auto kinds = line_kinds();
    for (const auto& more : {host_kinds(), clock_kinds(), firmware_kinds()})
      kinds.insert(kinds.end(), more.begin(), more.end());
    return kinds;
  }();
  return all;
}

}  // namespace syncline::bench
