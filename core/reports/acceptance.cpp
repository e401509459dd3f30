// SPDX-License-Identifier: Apache-2.0
#include "reports/acceptance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace syncline::reports {
namespace {

Verdict kept_if(bool kept) { return kept ? Verdict::kKept : Verdict::kNotKept; }

std::string time_text(Nanoseconds time) { return fmt::format("{:.3f} s", static_cast<double>(time) / 1e9); }

std::string limit_text(std::int64_t limit, double least_margin) {
  const auto text = fmt::format("in sync throughout, within ±{} ns", limit);
  return least_margin <= 0 ? text : text + fmt::format(" with {:g} % to spare", least_margin * 100);
}

/// One of the two verdicts: in sync at the end, never lost since, and as far from its limit as wanted.
Criterion judge_sync(std::string_view key, std::string_view name, const SyncLamp& lamp, const OverviewFigure& figure,
                     std::int64_t limit, const SyncOverview& overview, double least_margin) {
  Criterion criterion{key, name, {}, {}, Verdict::kNotJudged};
  if (!is_watched(lamp.state) || limit <= 0) {
    criterion.required = "in sync throughout";
    criterion.found = "not monitored";
    return criterion;
  }
  criterion.required = limit_text(limit, least_margin);
  if (!overview.armed) {
    criterion.found = fmt::format("{} at the end, never in sync before", sync_state_text(lamp.state));
    criterion.verdict = Verdict::kNotKept;
    return criterion;
  }
  criterion.found = fmt::format("{} for {}", sync_state_text(lamp.state), time_text(overview.end - lamp.since));
  if (lamp.times_lost > 0)
    criterion.found += fmt::format(", lost {} time{}", lamp.times_lost, lamp.times_lost == 1 ? "" : "s");
  const auto margin = figure.margin(limit);
  bool far_enough = true;
  if (margin) {
    criterion.found += fmt::format("; largest {} ns", std::abs(figure.largest->value));
    criterion.found +=
        *margin < 0 ? std::string(", over the limit") : fmt::format(", {:.0f} % margin", std::floor(*margin * 100));
    far_enough = *margin >= least_margin;
  }
  criterion.verdict =
      margin ? kept_if(lamp.state == SyncState::kInSync && lamp.times_lost == 0 && far_enough) : Verdict::kNotKept;
  if (!margin) criterion.found += "; no value since it was armed";
  return criterion;
}

/// How much a total has grown since `from`; nothing where the run does not tell it.
std::optional<std::uint64_t> grown(const SampleStore& store, Signal signal, Nanoseconds from) {
  const auto now = store.value(signal, store.heard(signal));
  if (!now) return std::nullopt;
  const auto before = store.series(signal).held_at(from);
  const auto difference = static_cast<double>(now->value) - (before ? static_cast<double>(before->value) : 0.0);
  return difference < 0 ? std::nullopt : std::optional(static_cast<std::uint64_t>(difference));
}

Criterion judge_count(std::string_view key, std::string_view name, const std::optional<std::uint64_t>& count,
                      std::uint64_t most, std::string_view why_unknown = "not told") {
  Criterion criterion{key, name, most == 0 ? "none" : fmt::format("{} at most", most), {}, Verdict::kNotJudged};
  criterion.found = count ? fmt::format("{}", *count) : std::string(why_unknown);
  if (count) criterion.verdict = kept_if(*count <= most);
  return criterion;
}

Criterion judge_time(const SyncOverview& overview, Nanoseconds least) {
  Criterion criterion{"watched_for", "Watched for", time_text(least), {}, Verdict::kNotJudged};
  if (least <= 0) criterion.required = "as long as it was";
  criterion.found = overview.armed ? time_text(overview.end - *overview.armed) : "never: it was not in sync in OP";
  criterion.verdict = kept_if(overview.armed && overview.end - *overview.armed >= least);
  return criterion;
}

Criterion judge_state(const SyncOverview& overview) {
  Criterion criterion{"state", "State of the master", "OP at the end", {}, Verdict::kNotJudged};
  criterion.found = std::string(al_state_name(overview.state));
  if (overview.state == AlState::kNone) criterion.found = "unknown: a slave does not answer, or it is not told";
  criterion.verdict = kept_if(overview.state == AlState::kOp);
  return criterion;
}

Criterion judge_faults(const SyncOverview& overview) {
  Criterion criterion{"faults", "Disturbances", "none", {}, Verdict::kNotJudged};
  const auto count = overview.faults.count();
  criterion.found = count == 0 ? "none" : fmt::format("{} episode{}", count, count == 1 ? "" : "s");
  if (overview.armed) criterion.verdict = kept_if(count == 0);
  return criterion;
}

Criterion judge_findings(std::span<const Finding> findings) {
  const auto count = [&](Severity severity) { return std::ranges::count(findings, severity, &Finding::severity); };
  const auto errors = count(Severity::kError), warnings = count(Severity::kWarning);
  Criterion criterion{"findings", "Findings", "no error, no warning", {}, kept_if(errors + warnings == 0)};
  criterion.found = errors + warnings == 0 ? "none"
                                           : fmt::format("{} error{}, {} warning{}", errors, errors == 1 ? "" : "s",
                                                         warnings, warnings == 1 ? "" : "s");
  return criterion;
}

/// Of slaves that follow a reference clock only that they were watched proves that they did; a master whose control is
/// off has nothing to prove.
Verdict overall(const Acceptance& acceptance, const SyncOverview& overview) {
  const auto verdict_of = [&](std::string_view key) {
    return std::ranges::find(acceptance.criteria, key, &Criterion::key)->verdict;
  };
  if (!overview.armed) return Verdict::kNotJudged;
  if (std::ranges::count(acceptance.criteria, Verdict::kNotKept, &Criterion::verdict) > 0) return Verdict::kNotKept;
  const bool followed = overview.deviation.statistics.count() > 0;
  return verdict_of(followed ? "slaves_in_sync" : "master_in_sync");
}

}  // namespace

std::string_view verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::kKept:
      return "kept";
    case Verdict::kNotKept:
      return "NOT KEPT";
    case Verdict::kNotJudged:
      return "not judged";
  }
  return {};
}

std::string_view verdict_key(Verdict verdict) {
  switch (verdict) {
    case Verdict::kKept:
      return "kept";
    case Verdict::kNotKept:
      return "not_kept";
    case Verdict::kNotJudged:
      return "not_judged";
  }
  return {};
}

std::string_view acceptance_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::kKept:
      return "accepted";
    case Verdict::kNotKept:
      return "NOT ACCEPTED";
    case Verdict::kNotJudged:
      return "NOT PROVEN";
  }
  return {};
}

Acceptance judge(const RunRecord& run, std::span<const Finding> findings, const AcceptanceLimits& limits) {
  const auto& overview = run.overview();
  const auto from = overview.armed.value_or(overview.begin);
  const auto& samples = run.samples();
  Acceptance result;
  auto& criteria = result.criteria;
  criteria.push_back(judge_time(overview, limits.least_time));
  criteria.push_back(judge_state(overview));
  criteria.push_back(judge_sync("slaves_in_sync", "Slaves against their reference clock", overview.slaves,
                                overview.deviation, run.limits().deviation_ns, overview, limits.least_margin));
  criteria.push_back(judge_sync("master_in_sync", "Reference clock against the master", overview.master,
                                overview.dcm_filtered, run.limits().dcm_error_ns, overview, limits.least_margin));
  criteria.push_back(judge_count("sm2_missed", "SM2 events missed",
                                 overview.missed.known ? std::optional(overview.missed.count) : std::nullopt,
                                 limits.most_missed_events, "no slave has a counter that is known"));
  criteria.push_back(
      judge_count("lost_frames", "Frames lost", grown(samples, Signal::kLostFrames, from), limits.most_lost_frames));
  criteria.push_back(judge_count("wkc_errors", "Cycles with another working counter than expected",
                                 grown(samples, Signal::kWkcErrors, from), limits.most_wkc_errors));
  criteria.push_back(judge_count("left_out_cycles", "Cycles left out by the host",
                                 grown(samples, Signal::kLeftOutCycles, from), limits.most_left_out));
  criteria.push_back(judge_faults(overview));
  criteria.push_back(judge_findings(findings));
  result.verdict = overall(result, overview);
  return result;
}

}  // namespace syncline::reports
