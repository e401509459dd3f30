// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// Codes of what a run shows (core/diagnosis); their words stand in run_slaves_words.h and run_bus_words.h.
namespace syncline::code {

inline constexpr std::string_view kSlaveAbsent = "slave-absent";
inline constexpr std::string_view kSlaveAbsentBehindCable = "slave-absent-behind-cable";
inline constexpr std::string_view kSlaveWasAbsent = "slave-was-absent";
inline constexpr std::string_view kAdapterAway = "adapter-away";
inline constexpr std::string_view kAdapterWasAway = "adapter-was-away";
inline constexpr std::string_view kSlaveFell = "slave-fell";
inline constexpr std::string_view kSlaveFellByMisses = "slave-fell-by-missed-events";
inline constexpr std::string_view kSlaveFellByLateFrames = "slave-fell-by-late-frames";
inline constexpr std::string_view kSlaveHadFallen = "slave-had-fallen";
inline constexpr std::string_view kSlaveLeftUnasked = "slave-left-unasked";
inline constexpr std::string_view kSlaveRefused = "slave-refused-state";
inline constexpr std::string_view kSlaveFellByItself = "slave-fell-by-itself";
inline constexpr std::string_view kSlaveFellByHang = "slave-fell-by-hang";
inline constexpr std::string_view kSlaveFellByMovedClock = "slave-fell-by-moved-clock";
inline constexpr std::string_view kSlaveBehind = "slave-behind";
inline constexpr std::string_view kNotMonitored = "not-monitored";
inline constexpr std::string_view kNothingToMonitor = "nothing-to-monitor";
inline constexpr std::string_view kSlavesOutOfSync = "slaves-out-of-sync";
inline constexpr std::string_view kSlavesSyncUnknown = "slaves-sync-unknown";
inline constexpr std::string_view kSlaveLeftWindow = "slave-out-of-sync";
inline constexpr std::string_view kWindowLeft = "sync-window-left";
inline constexpr std::string_view kReferenceWrittenLate = "reference-clock-written-late";
inline constexpr std::string_view kDelayNotMeasured = "delay-not-measured";
inline constexpr std::string_view kFramesWayChanged = "frames-way-changed";
inline constexpr std::string_view kSlaveClockOff = "slave-clock-off";
inline constexpr std::string_view kMasterNotLocked = "master-not-locked";
inline constexpr std::string_view kMasterLostLock = "master-lost-lock";
inline constexpr std::string_view kExternalClockNotMet = "external-clock-not-met";
inline constexpr std::string_view kExternalClockLeft = "external-clock-left";
inline constexpr std::string_view kDcmError = "dcm-error";
inline constexpr std::string_view kDriftTooHigh = "drift-too-high";
inline constexpr std::string_view kMissedByLostFrames = "missed-by-lost-frames";
inline constexpr std::string_view kMissedByHost = "missed-by-host";
inline constexpr std::string_view kMissedByHeldFrames = "missed-by-held-frames";
inline constexpr std::string_view kMissedByLateFrames = "missed-by-late-frames";
inline constexpr std::string_view kMissedUnlocked = "missed-unlocked";
inline constexpr std::string_view kMissedByMovedClock = "missed-by-moved-clock";
inline constexpr std::string_view kMissedUnexplained = "missed-unexplained";
inline constexpr std::string_view kSync0TooTight = "sync0-too-tight";
inline constexpr std::string_view kSync0Misplaced = "sync0-misplaced";
inline constexpr std::string_view kSync0Never = "sync0-never-comes";
inline constexpr std::string_view kShiftTooShort = "shift-too-short";
inline constexpr std::string_view kInputShiftTooShort = "input-shift-too-short";
inline constexpr std::string_view kFirmwareHung = "firmware-hung";
inline constexpr std::string_view kFirmwareHangs = "firmware-hangs";
inline constexpr std::string_view kFirmwareSlow = "firmware-slow";
inline constexpr std::string_view kInputsLate = "inputs-late";
inline constexpr std::string_view kOutputsLate = "outputs-late";
inline constexpr std::string_view kExceededByHost = "exceeded-by-host";
inline constexpr std::string_view kGatewayCycleExceeded = "gateway-cycle-exceeded";
inline constexpr std::string_view kMailboxSilent = "mailbox-silent";
inline constexpr std::string_view kOutputsWatchdog = "outputs-watchdog";
inline constexpr std::string_view kPortErrors = "port-errors";
inline constexpr std::string_view kLinkLost = "link-lost";
inline constexpr std::string_view kForeignFrames = "foreign-frames";
inline constexpr std::string_view kFramesLost = "frames-lost";
inline constexpr std::string_view kFramesLostBehind = "frames-lost-behind";
inline constexpr std::string_view kFramesLostInFront = "frames-lost-in-front";
inline constexpr std::string_view kFramesLostByNoise = "frames-lost-by-noise";
inline constexpr std::string_view kFramesLostByHost = "frames-lost-by-host";
inline constexpr std::string_view kFramesLostLast = "frames-lost-last";
inline constexpr std::string_view kFramesLostByCable = "frames-lost-by-interruption";
inline constexpr std::string_view kFramesLate = "frames-late";
inline constexpr std::string_view kHostStalled = "host-stalled";
inline constexpr std::string_view kHostStalledByOthers = "host-stalled-by-others";
inline constexpr std::string_view kHostHeldByKernel = "host-held-by-kernel";
inline constexpr std::string_view kHostHeldByProgram = "host-held-by-program";
inline constexpr std::string_view kHostTimerLate = "host-timer-late";
inline constexpr std::string_view kHostLate = "host-late";
inline constexpr std::string_view kJitterReachesClock = "host-jitter-reaches-clock";
inline constexpr std::string_view kWorkingCounter = "working-counter";
inline constexpr std::string_view kWorkingCounterNeverRight = "working-counter-never-right";
inline constexpr std::string_view kWorkingCounterExplained = "working-counter-explained";

}  // namespace syncline::code
