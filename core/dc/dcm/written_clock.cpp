// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/written_clock.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "config/dcm_settings.h"

namespace syncline::dc {
namespace {

/// Cycles over which the usual lateness is a mean; a single wake-up that is far off counts no more than this, ns.
constexpr int kLatenessMemory = 32;
constexpr double kLatenessChange = 2'000;

/// A message that was wrong by no more is left in the mean of 64, ns: more is taken back by another write.
constexpr Nanoseconds kTakenBack = 1'500;
/// So many cycles in a row, it was not the messages that were wrong.
constexpr int kMovedAfter = 3;

/// A clock that is told exact times is so near to them; what is farther from one cycle to the next is seen by those who
/// follow it (127 ns by default). A reading after more cycles may be off by a quartz that nobody told the time.
constexpr Nanoseconds kQuiet = 50, kNoticed = 100;
constexpr int kCyclesApart = 10;
/// For so long the clock may still move by what it was told wrong.
constexpr int kCyclesAfter = 20;

}  // namespace

WrittenClock::WrittenClock(Time time, const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value,
                           Nanoseconds least)
    : time_(time),
      target_{0, set_value, cycle_time},
      monitor_(settings, cycle_time, set_value, least),
      way_(cycle_time, time == Time::kOfSending ? kNoticed : settings.in_sync_limit / ChangedWay::kPartOfLimit),
      push_(static_cast<double>(settings.max_valid_value)),
      cycle_(cycle_time),
      in_sync_limit_(settings.in_sync_limit) {}

void WrittenClock::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  target_.base = base;
  monitor_.start(first_send_time);
  state_ = {};
  way_.start();
  usual_lateness_ = 0;
  observed_ = 0;
  last_lag_ = last_time_ = way_changed_ = 0;
  told_ = wrong_ = owed_ = 0;
  far_ = 0;
  again_ = substitute_ = false;
  host_ = first_send_time;
  reference_ = target_.nearest(first_reference_time);
}

std::optional<Nanoseconds> WrittenClock::reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) {
  if (time_ == Time::kOfSending) return wanted_at(send_time);
  if (substitute_) return push_.told_at(send_time);
  const auto usual = usual_lateness();
  const bool is_off = std::abs(send_time - scheduled_time - usual) > kMostShakenByNominal || again_;
  told_ = wanted_at(knows_usual() && is_off ? send_time - usual : scheduled_time) + owed_;
  return told_;
}

bool WrittenClock::knows_usual() const { return observed_ >= kLatenessMemory; }

bool WrittenClock::was_shaken(Nanoseconds reference_time) {
  wrong_ = reference_time - told_;
  const int before = std::exchange(far_, std::abs(wrong_) > kMostShakenByNominal ? far_ + 1 : 0);
  return knows_usual() && std::abs(wrong_) > kTakenBack && before < kMovedAfter;
}

/// Its own stamp may have been wrong as well. A clock that shows what it was told has itself moved: nothing is owed.
bool WrittenClock::observe_second_write(const DcmObservation& observation) {
  if (!observation.reference_time) return again_ = false;
  if (substitute_ && time_ == Time::kNominal) return push_.take_again(observation, lag_of(observation));
  if (!again_) return false;
  const auto wrong = *observation.reference_time - told_;
  const auto left = owed_ + wrong;
  const bool moved = std::abs(wrong) <= kMostShakenByNominal && std::abs(wrong) < std::abs(left);
  const bool paid = std::abs(left) <= kMostShakenByNominal;
  owed_ = moved || paid ? 0 : left;
  if (paid && !moved) far_ = 0;  // it was the message, and the next one may be wrong as well
  return again_ = owed_ != 0;
}

Nanoseconds WrittenClock::usual_lateness() const { return std::llround(usual_lateness_); }

void WrittenClock::learn_lateness(const DcmObservation& observation) {
  if (time_ != Time::kNominal) return;
  const double change = static_cast<double>(observation.send_time - observation.scheduled_time) - usual_lateness_;
  if (observed_ < kLatenessMemory) {
    usual_lateness_ += change / ++observed_;
  } else {
    usual_lateness_ += std::clamp(change, -kLatenessChange, kLatenessChange) / kLatenessMemory;
  }
}

Nanoseconds WrittenClock::lag_of(const DcmObservation& observation) const {
  return *observation.reference_time - wanted_at(observation.send_time - usual_lateness());
}

bool WrittenClock::tells_again(const DcmObservation& observation, Nanoseconds lag) {
  if (substitute_) return push_.take(observation, lag);
  again_ = was_shaken(*observation.reference_time);
  owed_ = again_ ? wrong_ : 0;
  return again_;
}

Nanoseconds WrittenClock::without_way(const DcmObservation& observation, Nanoseconds lag, DcmAction& action) {
  const auto jump = lag - last_lag_;
  const auto now = observation.send_time;
  const bool follows_closely = monitor_.in_sync() && now - last_time_ <= kCyclesApart * cycle_ &&
                               std::abs(last_lag_) <= kQuiet && now - way_changed_ > kCyclesAfter * cycle_;
  if (follows_closely && std::abs(jump) > kNoticed && std::abs(jump) <= in_sync_limit_) {
    reference_ += jump;
    lag = last_lag_;
    way_changed_ = now;
    action.write_again = true;
  }
  last_lag_ = lag;
  last_time_ = now;
  return lag;
}

void WrittenClock::set_led_by_substitute(bool substitute) {
  substitute_ = substitute;
  push_.start();
}

void WrittenClock::note_other_way() {
  monitor_.note_other_way();
  if (monitor_.in_sync()) way_.note();
}

DcmAction WrittenClock::observe(const DcmObservation& observation) {
  DcmAction action;
  Nanoseconds lag = 0;
  learn_lateness(observation);
  owed_ = 0;
  again_ = false;
  if (observation.reference_time) {
    const bool exact = time_ == Time::kOfSending;
    const auto expected = exact ? last_lag_ : std::llround(monitor_.filtered());
    const bool another_way = way_.take(lag_of(observation) + way_.offset() - expected);
    action.write_again = exact ? another_way : tells_again(observation, lag_of(observation));
    lag = exact ? without_way(observation, lag_of(observation), action) : lag_of(observation);
  }
  monitor_.observe(observation, lag);
  monitor_.lead_back();
  monitor_.report(state_);
  state_.usual_lateness = usual_lateness();
  return action;
}

}  // namespace syncline::dc
