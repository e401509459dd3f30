// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "support/types.h"

/// What a run means, in findings: each with its cause, the figures that prove it and what to do.
namespace syncline {

enum class FindingCode : std::uint8_t {
  // slaves that are not there
  kSlaveAbsent,
  kSlaveAbsentBehindCable,
  kSlaveWasAbsent,
  kAdapterAway,
  kAdapterWasAway,
  // AL states
  kSlaveFell,
  kSlaveFellByMisses,
  kSlaveFellByLateFrames,
  kSlaveFellByItself,
  kSlaveBehind,
  // clocks
  kNotMonitored,
  kNothingToMonitor,
  kSlavesOutOfSync,
  kSlaveLeftWindow,
  kWindowLeft,
  kSlaveClockOff,
  kMasterNotLocked,
  kMasterLostLock,
  kDcmError,
  kDriftTooHigh,
  // outputs and SYNC0
  kMissedByLostFrames,
  kMissedByHost,
  kMissedByLateFrames,
  kMissedUnlocked,
  kMissedUnexplained,
  kSync0TooTight,
  kShiftTooShort,
  kInputShiftTooShort,
  // firmware
  kFirmwareHung,
  kFirmwareSlow,
  kInputsLate,
  kGatewayCycleExceeded,
  kMailboxSilent,
  kOutputsWatchdog,
  // the wire
  kPortErrors,
  kLinkLost,
  kFramesLost,
  kFramesLostByNoise,
  kFramesLostByHost,
  kFramesLostByCable,
  kFramesLate,
  // the host
  kHostStalled,
  kHostLate,
  // process data
  kWorkingCounter,
  kWorkingCounterExplained,
};
/// One behind the last.
inline constexpr std::size_t kFindingCodes = static_cast<std::size_t>(FindingCode::kWorkingCounterExplained) + 1;

enum class FindingLevel : std::uint8_t { kNote, kWarning, kError };

/// One figure of the evidence. The name is that of its placeholder in the finding's words and of its JSON field.
struct Figure {
  enum class Unit : std::uint8_t {
    kCount,
    kTimes,  // "once", "3 times"
    kNanoseconds,
    kMoment,  // kMoment: ns since the run began
    kPpm,     // value in thousandths
    kSlave,   // position; `other` is the last one of a range, or the same; -1 the host, -2 nobody
    kPort,
    kHex16,
    kHex32,
    kAlStatus,
    kText,
  };
  std::string_view name;
  Unit unit = Unit::kCount;
  std::int64_t value = 0, other = 0;
  std::string text{};  // kText; kCount, kTimes: "at least" when it is not empty
  bool operator==(const Figure&) const = default;
};

struct RunFinding {
  FindingCode code = FindingCode::kNotMonitored;
  FindingLevel level = FindingLevel::kNote;
  int slave = -1;                // the one it is about; -1: the master, the bus or all
  Nanoseconds from = 0, to = 0;  // when, host clock; 0: the whole run
  std::vector<Figure> figures{};
  bool operator==(const RunFinding&) const = default;
};

/// Stable name for programs: "frames-lost-by-noise".
[[nodiscard]] std::string_view finding_code_name(FindingCode code);

/// English sentences with {placeholders}: what was seen with its cause, and what to do.
struct FindingWords {
  std::string_view why, mend;
};
[[nodiscard]] FindingWords finding_words(FindingCode code);

/// A figure in English and engineering units.
[[nodiscard]] std::string figure_text(const Figure& figure);
/// Fills a (possibly translated) template with the figures. Unknown placeholders stay.
[[nodiscard]] std::string fill_finding_template(std::string_view text, const RunFinding& finding);
/// English: what was seen, why, and what to do.
[[nodiscard]] std::string describe(const RunFinding& finding);

}  // namespace syncline
