// SPDX-License-Identifier: Apache-2.0
#include "reports/acceptance.h"

#include <algorithm>
#include <cmath>

#include "findings/finding.h"
#include "protocol/al_state.h"
#include "record/run_record.h"
#include "trace/sync_overview.h"

namespace syncline::reports {
namespace {

using Kind = Criterion::Kind;

Verdict kept_if(bool kept) { return kept ? Verdict::kKept : Verdict::kNotKept; }

/// What is held against a limit.
struct Held {
  std::optional<std::int64_t> magnitude;
  std::optional<double> margin;
  std::int64_t limit = 0;
};
Held held(const OverviewFigure& figure, std::int64_t limit) {
  const auto& largest = figure.largest;
  return {largest ? std::optional(std::abs(largest->value)) : std::nullopt, figure.margin(limit), limit};
}
Held held(const LastingMagnitude& lasting, std::int64_t limit) {
  const auto& largest = lasting.largest();
  return {largest ? std::optional(largest->magnitude) : std::nullopt, lasting.margin(limit), limit};
}

/// One of the two verdicts: in sync at the end, never lost since, and as far from its limit as wanted. A slave that
/// went while it followed the reference clock is a loss, too, as in the overview: the verdict itself speaks of the
/// others.
Criterion judge_sync(Kind kind, const SyncLamp& lamp, const Held& held, const SyncOverview& overview,
                     double least_margin) {
  const auto limit = held.limit;
  Criterion criterion{.kind = kind, .required = limit};
  criterion.state = lamp.state;
  criterion.state_for = overview.end - lamp.of_all_since();
  criterion.times_lost = lamp.times_any_lost();
  criterion.least_margin = least_margin;
  if (!is_watched(lamp.state) || limit <= 0) return criterion;
  criterion.found = held.magnitude;
  criterion.margin = held.margin;
  criterion.verdict = kept_if(overview.armed && lamp.state == SyncState::kInSync && lamp.times_any_lost() == 0 &&
                              criterion.margin && *criterion.margin >= least_margin);
  return criterion;
}

/// How much a total has grown since `from`; nothing where the run does not tell it.
std::optional<std::int64_t> grown(const SampleStore& store, Signal signal, Nanoseconds from) {
  const auto now = store.value(signal, store.heard(signal));
  if (!now) return std::nullopt;
  const auto before = store.series(signal).held_at(from);
  const auto difference = static_cast<double>(now->value) - (before ? static_cast<double>(before->value) : 0.0);
  return difference < 0 ? std::nullopt : std::optional(static_cast<std::int64_t>(difference));
}

Criterion judge_count(Kind kind, const std::optional<std::int64_t>& count, std::uint64_t most) {
  Criterion criterion{.kind = kind, .required = static_cast<std::int64_t>(most), .found = count};
  if (count) criterion.verdict = kept_if(*count <= criterion.required);
  return criterion;
}

Criterion judge_time(const SyncOverview& overview, Nanoseconds least) {
  Criterion criterion{.kind = Kind::kWatchedFor, .required = least};
  if (overview.armed) criterion.found = overview.end - *overview.armed;
  criterion.verdict = kept_if(criterion.found && *criterion.found >= least);
  return criterion;
}

Criterion judge_state(const SyncOverview& overview) {
  return {.kind = Kind::kState,
          .verdict = kept_if(overview.state == AlState::kOp),
          .required = static_cast<std::int64_t>(AlState::kOp),
          .found = static_cast<std::int64_t>(overview.state)};
}

Criterion judge_findings(std::span<const Finding> findings) {
  const auto count = [&](Severity severity) { return std::ranges::count(findings, severity, &Finding::severity); };
  Criterion criterion{.kind = Kind::kFindings, .found = count(Severity::kError)};
  criterion.warnings = static_cast<std::uint64_t>(count(Severity::kWarning));
  criterion.verdict = kept_if(*criterion.found == 0 && criterion.warnings == 0);
  return criterion;
}

/// Of slaves that follow a reference clock only that they were watched proves that they did; a master whose control is
/// off has nothing to prove.
Verdict overall(const Acceptance& acceptance, const SyncOverview& overview) {
  if (!acceptance.armed) return Verdict::kNotJudged;
  if (std::ranges::count(acceptance.criteria, Verdict::kNotKept, &Criterion::verdict) > 0) return Verdict::kNotKept;
  const bool followed = overview.deviation.statistics.count() > 0;
  return acceptance.of(followed ? Kind::kSlavesInSync : Kind::kMasterInSync).verdict;
}

}  // namespace

Acceptance judge(const RunRecord& run, std::span<const Finding> findings, const AcceptanceLimits& limits) {
  const auto& overview = run.overview();
  const auto from = overview.armed.value_or(overview.begin);
  const auto total = [&](Signal signal) { return grown(run.samples(), signal, from); };
  const auto missed =
      overview.missed.known ? std::optional(static_cast<std::int64_t>(overview.missed.count)) : std::nullopt;
  const auto episodes = static_cast<std::int64_t>(overview.faults.count());
  Acceptance result;
  result.armed = overview.armed.has_value();
  result.criteria = {judge_time(overview, limits.least_time),
                     judge_state(overview),
                     judge_sync(Kind::kSlavesInSync, overview.slaves,
                                held(overview.deviation, run.limits().deviation_ns), overview, limits.least_margin),
                     judge_sync(Kind::kMasterInSync, overview.master,
                                held(overview.dcm_lasting, run.limits().dcm_error_ns), overview, limits.least_margin),
                     judge_count(Kind::kMissedEvents, missed, limits.most_missed_events),
                     judge_count(Kind::kLostFrames, total(Signal::kLostFrames), limits.most_lost_frames),
                     judge_count(Kind::kWkcErrors, total(Signal::kWkcErrors), limits.most_wkc_errors),
                     judge_count(Kind::kLeftOutCycles, total(Signal::kLeftOutCycles), limits.most_left_out),
                     judge_count(Kind::kFaults, result.armed ? std::optional(episodes) : std::nullopt, 0),
                     judge_findings(findings)};
  result.verdict = overall(result, overview);
  return result;
}

}  // namespace syncline::reports
