// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "record/run_record.h"

namespace syncline::reports {

/// What a run must have shown to be accepted.
struct AcceptanceLimits {
  Nanoseconds least_time = 0;            // that it was watched for, since it was armed
  double least_margin = 0;               // part of the limit that the largest deviation must leave, 0..1
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
[[nodiscard]] std::string_view verdict_text(Verdict verdict);  // "kept", "NOT KEPT", "not judged"
[[nodiscard]] std::string_view verdict_key(Verdict verdict);   // "kept", "not_kept", "not_judged"

struct Criterion {
  std::string_view key;   // for programs: "slaves_in_sync"
  std::string_view name;  // for people
  std::string required, found;
  Verdict verdict = Verdict::kNotJudged;
  bool operator==(const Criterion&) const = default;
};

struct Acceptance {
  std::vector<Criterion> criteria;
  /// kNotKept: one of them is not. kNotJudged: the run was never armed, or neither slaves nor master were judged, so
  /// that nothing is proven about synchronisation. Else kKept, though single criteria may not have been judged.
  Verdict verdict = Verdict::kNotJudged;
};
/// "accepted", "NOT ACCEPTED", "NOT PROVEN"
[[nodiscard]] std::string_view acceptance_text(Verdict verdict);

/// Counted is what came since the run was armed: bring-up is no part of it. `findings`: what was found about the run.
[[nodiscard]] Acceptance judge(const RunRecord& run, std::span<const Finding> findings, const AcceptanceLimits& limits);

}  // namespace syncline::reports
