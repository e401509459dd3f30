// SPDX-License-Identifier: Apache-2.0
#include "dc/sync_verdict.h"

#include <algorithm>

#include "config/dc_settings.h"
#include "protocol/system_time_difference.h"

namespace syncline::dc {
namespace {

/// Those whose reading is to the side of the worst one, and at least half as large.
std::size_t count_alike(std::span<const ClockReading> readings, const ClockReading& worst) {
  const auto alike = [&worst](const ClockReading& reading) {
    return reading.follows && reading.read && (reading.deviation_ns > 0) == (worst.deviation_ns > 0) &&
           std::uint64_t{2} * reading.magnitude() >= worst.magnitude();
  };
  return static_cast<std::size_t>(std::ranges::count_if(readings, alike));
}

/// All of them over the limit and as far as the worst one, within a quarter, whatever the side: the sign of 0x092C has
/// two meanings (editions of the ESC data sheet), and both may be on one bus.
bool all_as_far(std::span<const ClockReading> readings, const SlavesEvidence& evidence) {
  const auto as_far = [&](const ClockReading& reading) {
    return !reading.follows || std::uint64_t{4} * reading.magnitude() >= std::uint64_t{3} * evidence.worst_ns;
  };
  return evidence.over == evidence.followers && std::ranges::all_of(readings, as_far);
}

/// What weigh() says where all are within the limit by the or-ed value of `now`, out of what it said in the cycle
/// before and the readings since. Empty: they do not tell, because one is over the limit, or the worst one has become
/// better.
std::optional<SlavesEvidence> with_news(SlavesEvidence evidence, std::span<const ClockReading> readings,
                                        std::span<const std::uint16_t> changed, std::uint32_t limit_ns,
                                        Nanoseconds now) {
  if (evidence.over > 0 || evidence.followers == 0) return std::nullopt;
  for (const auto position : changed) {
    const auto& reading = readings[position];
    if (!reading.follows || !reading.read) continue;
    const auto magnitude = reading.magnitude();
    const bool is_worst = evidence.worst == position;
    if (magnitude > limit_ns || (is_worst && magnitude < evidence.worst_ns)) return std::nullopt;
    evidence.newest = std::max(evidence.newest, reading.time);
    const bool first_of_alike = magnitude == evidence.worst_ns && position < evidence.worst;
    if (evidence.worst < 0 || magnitude > evidence.worst_ns || first_of_alike) evidence.worst = position;
    evidence.worst_ns = std::max(evidence.worst_ns, magnitude);
  }
  evidence.unread = 0;
  evidence.oldest = now;
  return evidence;
}

}  // namespace

SlavesEvidence weigh(std::span<const ClockReading> readings, std::uint32_t limit_ns,
                     std::optional<Nanoseconds> within) {
  SlavesEvidence evidence;
  const auto proven = within.value_or(INT64_MIN);
  Nanoseconds oldest = INT64_MAX;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto& reading = readings[i];
    if (!reading.follows) continue;
    ++evidence.followers;
    oldest = std::min(oldest, std::max(proven, reading.time));
    if (!reading.read) {
      evidence.unread += proven >= reading.time ? 0 : 1;
      continue;
    }
    evidence.newest = std::max(evidence.newest, reading.time);
    const auto magnitude = reading.magnitude();
    if (magnitude > limit_ns) {
      if (proven > reading.time) continue;  // that is over; an own reading in the same cycle is the newer one
      ++evidence.over;
    }
    if (evidence.worst >= 0 && magnitude <= evidence.worst_ns) continue;
    evidence.worst = static_cast<int>(i);
    evidence.worst_ns = magnitude;
  }
  if (evidence.over > 0) evidence.alike = count_alike(readings, readings[static_cast<std::size_t>(evidence.worst)]);
  if (evidence.over > 0 && all_as_far(readings, evidence)) evidence.alike = evidence.followers;
  if (evidence.followers > 0) evidence.oldest = oldest;
  return evidence;
}

SyncVerdict::SyncVerdict(const SyncWindowSettings& settings, bool monitored, Nanoseconds stale, Nanoseconds start)
    : state_(monitored ? State::kSettling : State::kNotMonitored),
      monitored_(monitored),
      limit_ns_(sync_window_limit_ns(settings.exponent)),
      settle_(settings.settle_time_ms * kMillisecond),
      stale_(stale),
      start_(start),
      since_(start) {}

SyncVerdict::Edge SyncVerdict::observe(const Input& input) {
  const auto& ored = input.ored;
  const bool ored_over = ored && ored->magnitude_ns > limit_ns_;
  if (ored && !ored_over && ored->covers_all) within_ = input.time;
  undecided_ = ored_over && !ored->followers_only;
  evidence_ = weighed(input);
  if (!monitored_) return Edge::kNone;
  if (evidence_.followers == 0 && input.led) {
    good_since_.reset();
    return enter(State::kNotMonitored, Edge::kNone, input.time);
  }
  return judge(input, evidence_.over > 0 || (ored_over && ored->followers_only));
}

/// All readings of a long machine in every cycle would cost more than everything else here.
SlavesEvidence SyncVerdict::weighed(const Input& input) const {
  if (input.changed && within_ == input.time) {
    if (const auto evidence = with_news(evidence_, input.readings, *input.changed, limit_ns_, input.time))
      return *evidence;
  }
  return weigh(input.readings, limit_ns_, within_);
}

SyncVerdict::Edge SyncVerdict::judge(const Input& input, bool over) {
  const bool known = input.led && input.time - evidence_.oldest <= stale_;
  if (!known || over) good_since_.reset();
  if (!known) return enter(State::kUnknown, was_in_sync_ ? Edge::kUnknown : Edge::kNone, input.time);
  if (over) {
    // Until they have been in sync for the first time they are on their way.
    return was_in_sync_ ? enter(State::kOutOfSync, Edge::kOutOfSync, input.time)
                        : enter(State::kSettling, Edge::kNone, input.time);
  }
  if (state_ == State::kInSync) return Edge::kNone;
  if (evidence_.unread == 0 && !good_since_) good_since_ = input.time;
  if (good_since_ && input.time - *good_since_ >= settle_) {
    was_in_sync_ = true;
    if (!settled_after_) settled_after_ = *good_since_ - start_;
    return enter(State::kInSync, Edge::kInSync, input.time);
  }
  return state_ == State::kOutOfSync ? Edge::kNone : enter(State::kSettling, Edge::kNone, input.time);
}

SyncVerdict::Edge SyncVerdict::enter(State state, Edge edge, Nanoseconds time) {
  if (state_ == state) return Edge::kNone;
  state_ = state;
  since_ = time;
  return edge;
}

}  // namespace syncline::dc
