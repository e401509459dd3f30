// SPDX-License-Identifier: Apache-2.0
#include "trace/trigger.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "channels/event.h"
#include "channels/event_finding.h"
#include "findings/finding.h"
#include "trace/sample_store.h"

namespace syncline {
namespace {

using Scope = SignalInfo::Scope;

/// Which of its series the trigger watches; nothing: the run does not have it.
std::optional<std::size_t> place_of(const Trigger& trigger, const SampleStore& store) {
  switch (info(trigger.signal).scope) {
    case Scope::kBus:
      break;
    case Scope::kSlave:
      if (trigger.slave < 0 || static_cast<std::size_t>(trigger.slave) >= store.slave_count()) return std::nullopt;
      return static_cast<std::size_t>(trigger.slave);
    case Scope::kVariable: {
      const auto& variables = store.watched().variables();
      const auto found = std::ranges::find(variables, trigger.variable, &WatchedVariable::name);
      if (found == variables.end()) return std::nullopt;
      return static_cast<std::size_t>(found - variables.begin());
    }
  }
  return 0;
}

int slave_of(const Trigger& trigger, const SampleStore& store) {
  if (info(trigger.signal).scope == Scope::kSlave) return trigger.slave;
  if (info(trigger.signal).scope == Scope::kBus) return -1;
  const auto place = place_of(trigger, store);
  return place ? store.watched().variables()[*place].slave : -1;
}

bool crosses(Trigger::Edge edge, double level, double before, double now) {
  const bool up = before < level && now >= level;
  const bool down = before > level && now <= level;
  return (up && edge != Trigger::Edge::kDown) || (down && edge != Trigger::Edge::kUp);
}

}  // namespace

bool finds_the_same(Trigger one, const Trigger& other) {
  one.mode = other.mode;
  return one == other;
}

TriggerWatch::TriggerWatch(Trigger trigger, Nanoseconds from)
    : trigger_(std::move(trigger)), next_(from), begin_(from) {}

bool TriggerWatch::look(const SampleStore& store, Nanoseconds portion) {
  if (trigger_.kind == Trigger::Kind::kEvent || trigger_.kind == Trigger::Kind::kFinding || done()) return true;
  const auto place = place_of(trigger_, store);
  if (!place) return true;
  const auto& series = store.series(trigger_.signal, *place);
  if (series.empty() || next_ > series.last_time()) return true;
  next_ = std::max(next_, series.first_time());
  const auto last = series.last_time();
  const auto end = portion > last - next_ ? last + 1 : next_ + portion;
  // A count or a state holds until its next change, however late that is; where it was lost there is a gap.
  const bool held = info(trigger_.signal).form == SignalInfo::Form::kHeld;
  const auto gap = held ? kAll : store.longest_gap(trigger_.signal);
  series.for_each(next_, end, [&](Nanoseconds time, float value) { take(time, value, gap, store); });
  next_ = end;
  return end > last;
}

void TriggerWatch::take(Nanoseconds time, float value, Nanoseconds longest_gap, const SampleStore& store) {
  if (done()) return;
  if (std::isnan(value)) return before_.reset();
  const auto now = trigger_.magnitude ? std::abs(static_cast<double>(value)) : static_cast<double>(value);
  const bool joined = before_ && time - before_time_ <= longest_gap;
  if (joined && fires(*before_, now)) {
    fire(time, slave_of(trigger_, store), static_cast<double>(value), store);
  }
  before_ = now;
  before_time_ = time;
}

bool TriggerWatch::fires(double before, double now) const {
  if (trigger_.kind == Trigger::Kind::kLevel) return crosses(trigger_.edge, trigger_.level, before, now);
  const auto inside = [this](double value) { return value >= trigger_.low && value <= trigger_.high; };
  return inside(before) != inside(now) && inside(now) == trigger_.enters;
}

void TriggerWatch::hear(const Event& event, const SampleStore& store) {
  if (trigger_.kind != Trigger::Kind::kEvent || done() || event.time < begin_) return;
  if (trigger_.slave >= 0 && event.slave != trigger_.slave) return;
  const auto told = event_finding(event);
  if (told && told->code == trigger_.code) fire(event.time, event.slave, 0, store);
}

void TriggerWatch::hear(std::span<const Finding> findings, const SampleStore& store) {
  if (trigger_.kind != Trigger::Kind::kFinding) return;
  std::vector<std::pair<Nanoseconds, int>> fresh;
  for (const auto& finding : findings) {
    if (finding.code != trigger_.code || finding.from < std::max<Nanoseconds>(begin_, 1)) continue;
    if (trigger_.slave >= 0 && finding.place.slave != trigger_.slave) continue;
    const std::pair moment(finding.from, finding.place.slave);
    if (found_.insert(moment).second) fresh.push_back(moment);
  }
  std::ranges::sort(fresh);
  for (const auto& [time, slave] : fresh) {
    if (!done()) fire(time, slave, 0, store);
  }
}

void TriggerWatch::fire(Nanoseconds time, int slave, double value, const SampleStore& store) {
  // Events may be told late: what lies before an episode's moment is within its hold-off, too.
  if (!episodes_.empty() && trigger_.hold_off > 0 && time < episodes_.back().time + trigger_.hold_off) {
    ++episodes_.back().left_out;
    ++left_out_;
    return;
  }
  if (episodes_.size() == kMostEpisodes) {
    constexpr std::size_t kHalf = kMostEpisodes / 2;
    episodes_.erase(episodes_.begin(), episodes_.begin() + kHalf);
    forgotten_ += kHalf;
  }
  episodes_.push_back({time, store.cycle_at(time), slave, value, time - trigger_.pre, time + trigger_.post, 0});
}

TriggerWatch::State TriggerWatch::state(Nanoseconds begin, Nanoseconds now) const {
  if (!episodes_.empty()) {
    const auto& last = episodes_.back();
    if (now < last.to) return State::kTriggered;
    if (done()) return State::kDone;
    if (now < last.time + trigger_.hold_off) return State::kHoldingOff;
  }
  return now - begin < trigger_.pre ? State::kFilling : State::kWaiting;
}

}  // namespace syncline
