// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/slaves_sync.h"

#include <algorithm>
#include <cstdlib>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "config/dc_settings.h"
#include "config/network_config.h"
#include "master/clocks/dc_setup.h"
#include "master/clocks/ored_deviation.h"
#include "master/exchange/event_teller.h"
#include "master/exchange/slave_states.h"

namespace syncline {
namespace {

/// A slave that does not answer must not keep the others' news.
constexpr Nanoseconds kCulpritPatience = 100 * kMillisecond;
/// One that has just come is found by its identity, which takes a hundred exchanges and more.
constexpr Nanoseconds kNewcomerPatience = kSecond;
/// Before slaves are off: what changes the frames' way, and what does so at that moment.
constexpr Nanoseconds kJust = kSecond, kAtOnce = 100 * kMillisecond;
/// Rounds of readings because of an or-ed value that hovers about the limit come no closer than this.
constexpr Nanoseconds kRoundPeriod = 100 * kMillisecond;
/// Readings in turn may be lost with their frames several times before nobody knows any more.
constexpr Nanoseconds kLeastStaleReading = 500 * kMillisecond;
constexpr int kStaleRounds = 4;
/// So long must the readings of a clock be small that was away and whose slave does not work yet; and after so long it
/// counts in any case where the slave works.
constexpr Nanoseconds kCatchingUp = 300 * kMillisecond, kMostCatchingUp = 500 * kMillisecond;

SyncState state_of(dc::SyncVerdict::State state) {
  switch (state) {
    case dc::SyncVerdict::State::kNotMonitored:
      return SyncState::kNotMonitored;
    case dc::SyncVerdict::State::kSettling:
      return SyncState::kBusy;
    case dc::SyncVerdict::State::kInSync:
      return SyncState::kInSync;
    case dc::SyncVerdict::State::kOutOfSync:
      return SyncState::kOutOfSync;
    case dc::SyncVerdict::State::kUnknown:
      return SyncState::kUnknown;
  }
  return SyncState::kNotReady;
}

}  // namespace

void SlavesSync::start(const DcNetwork& network, Nanoseconds first_cycle, bool steered) {
  const auto& config = config_;
  steered_ = steered;
  readings_.assign(config.slaves.size(), {});
  for (auto& reading : readings_) reading.time = first_cycle;
  lost_.assign(config.slaves.size(), 0);
  returned_.assign(config.slaves.size(), 0);
  returns_.assign(config.slaves.size(), {});
  out_since_.reset();
  round_since_.reset();
  known_.reset();
  other_way_.reset();
  verdict_time_ = first_cycle;
  awaited_.clear();
  awaited_.reserve(config.slaves.size());
  auto& dc = snapshot_.dc;
  dc.reference_clock = network.reference_clock;
  dc.monitored = config.dc.sync_window.enabled && network.synchronised_count() >= 2;
  const auto round = static_cast<Nanoseconds>(network.synchronised_count()) * config.cycle_time();
  verdict_ = dc::SyncVerdict(config.dc.sync_window, dc.monitored, std::max(kLeastStaleReading, kStaleRounds * round),
                             first_cycle);
  dc.limit_ns = verdict_.limit_ns();
  dc.state = state_of(verdict_.state());
  dc.since = first_cycle;
}

void SlavesSync::observe(Nanoseconds time, bool led, bool distributed, std::span<const std::uint16_t> read,
                         const std::optional<OredDeviation>& ored, CycleSample& sample) {
  verdict_time_ = time;
  const bool same_followers = take_readings(time, distributed, read);
  if (ored) {
    ored_ns_ = ored->magnitude_ns;
    snapshot_.dc.deviation_ored_ns = ored_ns_;
    sample.deviation_ored_ns = ored_ns_;
    sample.flags |= CycleSample::kDeviationValid;
  }
  dc::SyncVerdict::Input input{time, led, readings_, {}, {}};
  if (same_followers) input.changed = read;
  if (ored && distributed) input.ored = meaning(*ored);
  const auto edge = verdict_.observe(input);
  report(time, sample);
  if (const auto& deviation = snapshot_.dc.deviation_ns) {
    sample.deviation_ns = input.ored && input.ored->followers_only ? ored_ns_ : *deviation;
    sample.flags |= CycleSample::kFollowersRead;
  }
  look_closer(time);
  tell(edge, time);
}

bool SlavesSync::take_readings(Nanoseconds time, bool distributed, std::span<const std::uint16_t> read) {
  for (const auto slave : awaited_) note_catching_up(slave, time);
  const bool news = known_ != Known{states_.slave_changes(), snapshot_.dc.reference_clock};
  const bool look = news || std::ranges::any_of(awaited_, [&](auto slave) { return is_back(slave, time); });
  if (look) look_who_follows(time);
  if (!distributed) return !look;
  for (const std::size_t i : read) {
    const auto& slave = snapshot_.slaves[i];
    if (!slave.deviation_valid || slave.deviation_time != time) continue;
    auto& reading = readings_[i];
    reading.read = true;
    reading.time = time;
    reading.deviation_ns = slave.deviation_ns;
    tell_return(i, time);
  }
  return !look;
}

/// Who is away stays away until presence changes; only who answers and has yet to catch up may do so in any cycle.
void SlavesSync::look_who_follows(Nanoseconds time) {
  followers_ = 0;
  alone_ = true;
  awaited_.clear();
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    auto& slave = snapshot_.slaves[i];
    auto& reading = readings_[i];
    const bool stays = slave.present && (lost_[i] | returned_[i]) == 0;
    const bool follows = stays ? may_follow(i) : follows_again(i, time);
    if (follows != reading.follows) reading = {follows, false, time, 0};
    slave.follows = follows;
    followers_ += follows ? 1 : 0;
    const bool leads = static_cast<int>(i) == snapshot_.dc.reference_clock;
    alone_ = alone_ && (follows || leads || !slave.dc_enabled || !slave.present);
    if (slave.present && lost_[i] != 0 && may_follow(i)) awaited_.push_back(i);
  }
  known_ = {states_.slave_changes(), snapshot_.dc.reference_clock};
}

bool SlavesSync::may_follow(std::size_t slave) const {
  const auto leader = snapshot_.dc.reference_clock;
  return snapshot_.slaves[slave].dc_enabled && leader >= 0 && static_cast<int>(slave) > leader;
}

bool SlavesSync::follows_again(std::size_t slave, Nanoseconds time) {
  const bool present = snapshot_.slaves[slave].present;
  const bool was_lost = lost_[slave] != 0;
  const bool leads = static_cast<int>(slave) == snapshot_.dc.reference_clock;
  const bool catches_up = present && may_follow(slave);
  if (!catches_up) returns_[slave] = {};
  if (!present) {
    lost_[slave] = 1;
  } else if (was_lost && (leads || (catches_up && is_back(slave, time)))) {
    lost_[slave] = 0;
  }
  const bool follows = catches_up && lost_[slave] == 0;
  returned_[slave] = present && !leads && (returned_[slave] != 0 || (was_lost && lost_[slave] == 0)) ? 1 : 0;
  return follows;
}

/// The others stayed in sync, and so no edge of the verdict says that this one is again.
void SlavesSync::tell_return(std::size_t slave, Nanoseconds time) {
  const auto& reading = readings_[slave];
  const bool within = reading.follows && reading.magnitude() <= verdict_.limit_ns();
  if (returned_[slave] == 0 || !within || verdict_.state() != dc::SyncVerdict::State::kInSync) return;
  returned_[slave] = 0;
  teller_.tell(time, static_cast<int>(slave), events::SlavesInSync{reading.magnitude()});
}

void SlavesSync::note_catching_up(std::size_t slave, Nanoseconds time) {
  const auto& status = snapshot_.slaves[slave];
  auto& [since, near_since] = returns_[slave];
  if (!since) since = time;
  if (!status.deviation_valid || status.deviation_time != time) return;
  if (std::abs(std::int64_t{status.deviation_ns}) > verdict_.limit_ns()) return near_since.reset();
  if (!near_since) near_since = time;
}

/// A clock that was away ran on by itself, or is set up anew. It counts again when its slave works with it and it has
/// caught up, or has had the time to; while the slave does not work, not at its first small readings: a clock that was
/// just set drifts away before its loop has learned the quartz.
bool SlavesSync::is_back(std::size_t slave, Nanoseconds time) const {
  const auto& [since, near_since] = returns_[slave];
  const bool works = has_process_data_communication(al_state_of(snapshot_.slaves[slave].al_status));
  if (works) return near_since.has_value() || (since && time - *since >= kMostCatchingUp);
  return near_since && time - *near_since >= kCatchingUp;
}

/// A slave in front of the reference clock gets the master's time, and a reference clock that the master steers has its
/// error against the host: what ors them is over the limit for reasons that are none of the followers'.
dc::OredReading SlavesSync::meaning(const OredDeviation& ored) const {
  const auto& dc = snapshot_.dc;
  const auto with_leader = followers_ + 1;
  bool leader_is_quiet = dc.reference_clock >= 0;
  if (leader_is_quiet) {
    const auto& own = readings_[static_cast<std::size_t>(dc.reference_clock)];
    leader_is_quiet = !own.read || own.magnitude() <= verdict_.limit_ns();
  }
  // One that has just gone and another one that is no follower would make up the same count.
  const bool theirs = alone_ && ored.wkc == with_leader;
  return {ored.magnitude_ns, ored.wkc >= with_leader, theirs && !steered_ && leader_is_quiet};
}

void SlavesSync::report(Nanoseconds time, CycleSample& sample) {
  auto& dc = snapshot_.dc;
  const auto& evidence = verdict_.evidence();
  dc.state = state_of(verdict_.state());
  dc.since = verdict_.since();
  dc.followers = static_cast<std::uint16_t>(evidence.followers);
  dc.over_limit = static_cast<std::uint16_t>(evidence.over);
  dc.all_alike = evidence.all_alike();
  dc.culprit = dc.monitored && evidence.over > 0 && !dc.all_alike ? evidence.worst : -1;
  dc.deviation_ns.reset();
  if (evidence.worst >= 0) dc.deviation_ns = evidence.worst_ns;
  dc.newest_age_ns = evidence.newest > 0 ? time - evidence.newest : -1;
  dc.oldest_age_ns = evidence.followers > 0 ? time - evidence.oldest : -1;
  if (const auto settled = verdict_.settled_after()) dc.settled_after_ms = to_milliseconds(*settled);
  sample.slaves_sync = dc.state;
  const auto position = static_cast<std::size_t>(sample.slave_position);
  if (sample.slave_position >= 0 && readings_[position].follows) sample.flags |= CycleSample::kSlaveFollows;
}

/// An or-ed value that has just left the limit for an unknown reason: everybody is read at once.
void SlavesSync::look_closer(Nanoseconds time) {
  const bool risen = verdict_.undecided() && !was_undecided_;
  was_undecided_ = verdict_.undecided();
  if (round_since_ && (all_read_since(*round_since_) || time - *round_since_ >= kCulpritPatience)) round_since_.reset();
  if (!risen || time < next_round_) return;
  round_since_ = time;
  next_round_ = time + kRoundPeriod;
}

bool SlavesSync::all_read_since(Nanoseconds time) const {
  return std::ranges::all_of(readings_, [time](const auto& r) { return !r.follows || (r.read && r.time > time); });
}

void SlavesSync::tell(dc::SyncVerdict::Edge edge, Nanoseconds time) {
  const auto& evidence = verdict_.evidence();
  switch (edge) {
    case dc::SyncVerdict::Edge::kInSync:
      if (out_since_) tell_culprit(*out_since_ + kCulpritPatience, true);
      returned_.assign(returned_.size(), 0);
      teller_.tell(time, -1, events::SlavesInSync{evidence.worst >= 0 ? evidence.worst_ns : ored_ns_});
      return;
    case dc::SyncVerdict::Edge::kUnknown:
      if (out_since_) tell_culprit(*out_since_ + kCulpritPatience, true);
      teller_.tell(time, -1, events::SlavesSyncUnknown{evidence.followers > 0 ? time - evidence.oldest : 0});
      return;
    case dc::SyncVerdict::Edge::kOutOfSync:
      out_since_ = time;
      out_by_ = ored_ns_;
      out_culprit_ = -1;
      out_count_ = 0;
      out_alike_ = false;
      way_of_.reset();
      off_ = {};
      break;
    case dc::SyncVerdict::Edge::kNone:
      break;
  }
  tell_culprit(time);
}

/// It went or came, no longer before than that.
bool SlavesSync::has_moved(std::size_t slave, Nanoseconds time, Nanoseconds before) const {
  const auto moved = snapshot_.slaves[slave].moved;
  return moved != 0 && time - moved < before;
}

/// They soon follow again, with delays that are not theirs any more: what was seen at once counts. Who comes back is
/// off on its own account.
void SlavesSync::note_off(Nanoseconds time) {
  constexpr std::int64_t kLongestWay = 10'000;  // ns
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    const auto& reading = readings_[i];
    if (!reading.follows || reading.magnitude() <= verdict_.limit_ns() || has_moved(i, time, kJust)) continue;
    off_.far = off_.far || std::abs(std::int64_t{reading.deviation_ns}) > kLongestWay;
    off_.first = std::min(off_.first.value_or(i), i);
    (reading.deviation_ns < 0 ? off_.sooner : off_.later) = true;
  }
}

/// The first of those that were off, where they were so by no more than delays are.
std::optional<std::size_t> SlavesSync::first_of_a_way() const { return off_.far ? std::nullopt : off_.first; }

/// The slave behind which the frames' way has changed: it went or came just before, and all that were off stand behind
/// it. They were so to the same side, at first: within milliseconds their loops go beyond where they want to.
std::optional<std::size_t> SlavesSync::who_moved(Nanoseconds time) const {
  const auto first = first_of_a_way();
  const auto leader = snapshot_.dc.reference_clock;
  if (!first || leader < 0) return std::nullopt;
  const auto just = off_.later != off_.sooner ? kJust : kAtOnce;
  // It was away itself, with whoever else: clocks that nobody led meanwhile, and no change of the way.
  if (has_moved(static_cast<std::size_t>(leader), time, kJust)) return std::nullopt;
  // Whoever stands in front of the reference clock changes its own way as much as the others'.
  for (auto i = static_cast<std::size_t>(leader) + 1; i < *first; ++i) {
    if (has_moved(i, time, just)) return i;
  }
  return std::nullopt;
}

/// One that is away may be about to come back: it changes the way of all that follow, or of those behind it, before it
/// answers.
bool SlavesSync::somebody_may_come() const {
  const auto behind = out_alike_ ? snapshot_.slaves.size() : first_of_a_way().value_or(0);
  return std::ranges::any_of(std::span(snapshot_.slaves).first(behind),
                             [](const SlaveStatus& slave) { return !slave.present; });
}

/// The wire-ored value names nobody: told when every slave has been read since. Only who was seen over the limit is
/// to blame, of several the one that was furthest away, and none when all have moved alike: that was the reference
/// clock.
void SlavesSync::tell_culprit(Nanoseconds time, bool at_once) {
  if (!out_since_) return;
  const auto& evidence = verdict_.evidence();
  if (evidence.over > 0 && (out_culprit_ < 0 || evidence.worst_ns > out_by_)) {
    out_culprit_ = evidence.worst;
    out_by_ = evidence.worst_ns;
  }
  out_count_ = std::max(out_count_, evidence.over);
  out_alike_ = out_alike_ || evidence.all_alike();
  if (out_alike_) out_count_ = evidence.followers;  // all of them have moved
  note_off(time);
  if (!way_of_) way_of_ = who_moved(time);
  const bool may_come = !way_of_ && somebody_may_come();
  const bool comes = may_come && other_way_ && std::abs(*other_way_ - *out_since_) < kJust;
  const bool wait = may_come || !all_read_since(*out_since_);
  if (!at_once && wait && time - *out_since_ < (comes ? kNewcomerPatience : kCulpritPatience)) return;
  if (way_of_) {
    teller_.tell(*out_since_, -1, events::SlavesOutOfSync{out_by_, 0});
    teller_.tell(*out_since_, static_cast<int>(*way_of_), events::FramesWayChanged{out_by_, out_count_});
  } else {
    teller_.tell(*out_since_, out_alike_ ? -1 : out_culprit_, events::SlavesOutOfSync{out_by_, out_count_});
  }
  out_since_.reset();
}

}  // namespace syncline
