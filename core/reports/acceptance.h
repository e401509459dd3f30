// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "channels/cycle_sample.h"
#include "support/types.h"

namespace syncline {
struct Finding;
class RunRecord;
}  // namespace syncline

namespace syncline::reports {

/// What a run must have shown to be accepted.
struct AcceptanceLimits {
  Nanoseconds least_time = 0;            // that it was watched for, since it was armed
  double least_margin = 0;               // part of the limit that what is found must leave, 0..1
  std::uint64_t most_lost_frames = 0;    // since it was armed; the same of the others
  std::uint64_t most_wkc_errors = 0;     // cycles
  std::uint64_t most_left_out = 0;       // cycles that the host was too late for
  std::uint64_t most_missed_events = 0;  // of SM2, of all slaves
};

enum class Verdict : std::uint8_t {
  kKept,
  kNotKept,
  kNotJudged,  // nothing is watched that would tell, or the recording does not hold it
};

struct Criterion {
  enum class Kind : std::uint8_t {
    kWatchedFor,    // `required` and `found`: ns; none found: never armed
    kState,         // AlState
    kSlavesInSync,  // `required`: the limit, ns; `found`: the largest magnitude, ns
    kMasterInSync,  // the same; `found`: the largest magnitude of the filtered error that has lasted, ns
    kMissedEvents,  // this and the next: `required` at most, `found`; none: not told
    kLostFrames,
    kWkcErrors,
    kLeftOutCycles,
    kFaults,    // `found`: episodes
    kFindings,  // `found`: errors
  };
  Kind kind = Kind::kWatchedFor;
  Verdict verdict = Verdict::kNotJudged;
  std::int64_t required = 0;
  std::optional<std::int64_t> found{};
  std::uint64_t warnings = 0;  // of kFindings
  // of the two that are about being in sync:
  SyncState state = SyncState::kNotMonitored;  // at the end
  Nanoseconds state_for = 0;                   // how long it has been that
  std::uint64_t times_lost = 0;
  double least_margin = 0;         // 0..1
  std::optional<double> margin{};  // part of the limit that the largest left; negative: over it
};

struct Acceptance {
  std::vector<Criterion> criteria;  // one of each kind, in their order
  bool armed = false;
  /// kNotKept: one of them is not. kNotJudged: nothing is proven about synchronisation, because the run was never
  /// armed, slaves follow a reference clock and nobody watched them, or none does and nobody watched the master. Else
  /// kKept, though single criteria may not have been judged.
  Verdict verdict = Verdict::kNotJudged;

  [[nodiscard]] const Criterion& of(Criterion::Kind kind) const { return criteria[static_cast<std::size_t>(kind)]; }
};

/// Counted is what came since the run was armed: bring-up is no part of it. `findings`: what was found about the run.
[[nodiscard]] Acceptance judge(const RunRecord& run, std::span<const Finding> findings, const AcceptanceLimits& limits);

/// For programs: "slaves_in_sync"; "kept", "not_kept", "not_judged".
[[nodiscard]] std::string_view criterion_key(Criterion::Kind kind);
[[nodiscard]] std::string_view verdict_key(Verdict verdict);
/// In English: "kept", "NOT KEPT", "not judged"; of the whole "accepted", "NOT ACCEPTED", "NOT PROVEN".
[[nodiscard]] std::string_view verdict_text(Verdict verdict);
[[nodiscard]] std::string_view acceptance_text(Verdict verdict);
[[nodiscard]] std::string_view criterion_text(Criterion::Kind kind);
[[nodiscard]] std::string required_text(const Criterion& criterion);
[[nodiscard]] std::string found_text(const Criterion& criterion);

}  // namespace syncline::reports
