// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "trace/run_report.h"

/// What a run's figures mean: pure rules on a RunReport, each with the numbers that prove it.
namespace syncline {

enum class DiagnosisCode : std::uint8_t {
  kSlaveError,          // slave, a = AL status, b = AL status code
  kSlaveLeftState,      // slave, a = AL status; the others went further
  kNotMonitored,        // DC runs, nobody watches the deviation
  kSlavesOutOfSync,     // slave = worst, a = its deviation ns, b = limit ns
  kMasterNotLocked,     // a = error ns, DCM not in sync
  kDriftTooHigh,        // a = drift in ppm
  kSm2MissedUnlocked,   // slave, a = missed events while the master is not locked
  kSm2MissedLocked,     // slave, a = missed events although the master is locked: frames too late for SYNC0
  kWorkingCounter,      // a = cycles with a wrong working counter
  kFramesLost,          // a = frames
  kOverruns,            // a = cycles that began more than a cycle late
};

enum class DiagnosisSeverity : std::uint8_t { kNote, kWarning, kError };

struct DiagnosisFinding {
  DiagnosisCode code = DiagnosisCode::kNotMonitored;
  DiagnosisSeverity severity = DiagnosisSeverity::kNote;
  int slave = -1;
  std::int64_t a = 0, b = 0;
  bool operator==(const DiagnosisFinding&) const = default;
};

/// Most severe first, then by slave.
[[nodiscard]] std::vector<DiagnosisFinding> diagnose(const RunReport& report);

/// English: what was seen, and what to do.
[[nodiscard]] std::string describe(const DiagnosisFinding& finding);

}  // namespace syncline
