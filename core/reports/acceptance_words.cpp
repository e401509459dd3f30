// SPDX-License-Identifier: Apache-2.0
// What the criteria say in English, and to programs.
#include <fmt/format.h>

#include <cmath>

#include "findings/acceptance_words.h"
#include "protocol/al_state.h"
#include "reports/acceptance.h"
#include "support/counted.h"
#include "trace/signals.h"

namespace syncline::reports {
namespace {

using Kind = Criterion::Kind;

static_assert(std::size(words::kCriteria) == static_cast<std::size_t>(Kind::kFindings) + 1);
static_assert(std::size(words::kVerdicts) == static_cast<std::size_t>(Verdict::kNotJudged) + 1);

std::string time_text(Nanoseconds time) { return fmt::format("{:.3f} s", static_cast<double>(time) / 1e9); }

std::string sync_found(const Criterion& criterion) {
  if (criterion.verdict == Verdict::kNotJudged) return "not monitored";
  auto text = fmt::format("{} for {}", sync_state_text(criterion.state), time_text(criterion.state_for));
  if (criterion.times_lost > 0) text += ", lost " + counted(static_cast<std::int64_t>(criterion.times_lost), "time");
  if (!criterion.margin) return text + "; no value since it was armed";
  const auto* lasted = criterion.kind == Kind::kMasterInSync ? " that lasted" : "";
  text += fmt::format("; largest{} {} ns, ", lasted, *criterion.found);
  return text + (*criterion.margin < 0 ? std::string("over the limit")
                                       : fmt::format("{:.0f} % margin", std::floor(*criterion.margin * 100)));
}

}  // namespace

std::string_view criterion_key(Kind kind) { return words::kCriteria[static_cast<std::size_t>(kind)].key; }
std::string_view criterion_text(Kind kind) { return words::kCriteria[static_cast<std::size_t>(kind)].name; }

std::string_view verdict_key(Verdict verdict) {
  constexpr std::string_view kKeys[] = {"kept", "not_kept", "not_judged"};
  return kKeys[static_cast<std::size_t>(verdict)];
}

std::string_view verdict_text(Verdict verdict) { return words::kVerdicts[static_cast<std::size_t>(verdict)]; }

std::string_view acceptance_text(Verdict verdict) {
  constexpr std::string_view kTexts[] = {"accepted", "NOT ACCEPTED", "NOT PROVEN"};
  return kTexts[static_cast<std::size_t>(verdict)];
}

std::string required_text(const Criterion& criterion) {
  switch (criterion.kind) {
    case Kind::kWatchedFor:
      return criterion.required <= 0 ? std::string(words::kAsLongAsItWas) : time_text(criterion.required);
    case Kind::kState:
      return std::string(words::kOpAtTheEnd);
    case Kind::kSlavesInSync:
    case Kind::kMasterInSync: {
      if (criterion.required <= 0) return std::string(words::kInSyncThroughout);
      auto text = fmt::format("in sync throughout, within ±{} ns", criterion.required);
      if (criterion.least_margin > 0) text += fmt::format(" with {:g} % to spare", criterion.least_margin * 100);
      return text;
    }
    case Kind::kFindings:
      return std::string(words::kNoErrorNoWarning);
    default:
      return criterion.required == 0 ? "none" : fmt::format("{} at most", criterion.required);
  }
}

std::string found_text(const Criterion& criterion) {
  switch (criterion.kind) {
    case Kind::kWatchedFor:
      return criterion.found ? time_text(*criterion.found) : std::string(words::kNeverInSync);
    case Kind::kState: {
      const auto state = static_cast<AlState>(*criterion.found);
      return std::string(state == AlState::kNone ? words::kStateUnknown : al_state_name(state));
    }
    case Kind::kSlavesInSync:
    case Kind::kMasterInSync:
      return sync_found(criterion);
    case Kind::kFaults:
      if (!criterion.found) return std::string(words::kNeverArmed);
      return *criterion.found == 0 ? "none" : counted(*criterion.found, "episode");
    case Kind::kFindings:
      if (criterion.verdict == Verdict::kKept) return "none";
      return counted(*criterion.found, "error") + ", " +
             counted(static_cast<std::int64_t>(criterion.warnings), "warning");
    case Kind::kMissedEvents:
      return criterion.found ? fmt::format("{}", *criterion.found) : std::string(words::kNoCounterKnown);
    default:
      return criterion.found ? fmt::format("{}", *criterion.found) : std::string(words::kNotTold);
  }
}

}  // namespace syncline::reports
