// SPDX-License-Identifier: Apache-2.0
#include "dc/sync_event_account.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "protocol/sync_error_counter.h"

namespace syncline::dc {
namespace {

std::uint32_t sum(const MissesByCause& misses) { return std::accumulate(misses.begin(), misses.end(), 0U); }

std::uint32_t& at(MissesByCause& misses, MissCause cause) { return misses[static_cast<std::size_t>(cause)]; }

}  // namespace

void SyncEventAccount::observe(const Cycle& cycle) {
  any_since_reading_ = true;
  const auto arrival = sync0_arrival(grid_, cycle.time);
  const auto period = arrival.number;
  left_out_ += cycle.left_out;
  if (!evaluated_) {
    // The first outputs begin the account: nobody knows what came before.
    if (!cycle.delivered) return;
    evaluated_ = delivered_ = period;
    frames_lost_ = held_up_ = left_out_ = 0;
    return;
  }
  const auto meant = cycle.held > 0 ? sync0_arrival(grid_, cycle.time - cycle.held).number : period;
  if (cycle.delivered && meant < period)
    held_up_ += static_cast<std::uint32_t>(std::min<std::int64_t>(period - meant, UINT16_MAX));
  const auto ended = period - *evaluated_;
  if (ended > 0) {
    const bool served = delivered_ == evaluated_;
    end_periods(ended, ended - (served ? 1 : 0));
    evaluated_ = period;
  }
  if (cycle.delivered) {
    if (delivered_ != period && arrival.phase != 0 && arrival.margin < cycle.need)
      ++(arrival.margin + cycle.held < cycle.need ? doubtful_.late : doubtful_.held_up);
    delivered_ = std::max(delivered_.value_or(period), period);
    frames_lost_ = held_up_ = left_out_ = 0;
  } else {
    ++frames_lost_;
  }
}

/// The good ones first: outputs come at the beginning of a gap.
void SyncEventAccount::end_periods(std::int64_t ended, std::int64_t missed) {
  const auto good = static_cast<std::uint32_t>(std::clamp<std::int64_t>(ended - missed, 0, UINT16_MAX));
  if (at_limit()) return;  // it has given up, or the next reading tells otherwise
  const auto counted_down = std::min(integrator_, good);
  integrator_ -= counted_down;
  counted_down_ += counted_down;
  for (std::int64_t i = 0; i < std::min<std::int64_t>(missed, UINT16_MAX) && !at_limit(); ++i) {
    integrator_ += kMissWeight;
    presume(1);
  }
  candidate_ = std::max(candidate_, integrator_);
}

void SyncEventAccount::presume(std::uint32_t missed) {
  const auto take = [&](std::uint32_t& pool, MissCause cause) {
    const auto part = std::min(pool, missed);
    pool -= part;
    missed -= part;
    at(presumed_, cause) += part;
  };
  take(frames_lost_, MissCause::kFrameLost);
  take(left_out_, MissCause::kCyclesLeftOut);
  take(held_up_, MissCause::kFrameHeldUp);
  at(presumed_, MissCause::kFrameLate) += missed;
}

/// The latest first: a frame comes soon after its cycle or never.
void SyncEventAccount::came_late(std::uint32_t cycles) {
  const auto move = [&cycles](std::uint32_t& lost, std::uint32_t& held_up) {
    const auto part = std::min(lost, cycles);
    lost -= part;
    held_up += part;
    cycles -= part;
  };
  move(frames_lost_, held_up_);
  for (auto* pool : {&presumed_, &carried_, &by_cause_}) {
    move(at(*pool, MissCause::kFrameLost), at(*pool, MissCause::kFrameHeldUp));
  }
}

/// Explains up to `debt` misses of the slave by what was presumed, the older ones first; what is left.
std::uint32_t SyncEventAccount::explain(std::uint32_t debt) {
  for (auto* pool : {&carried_, &presumed_}) {
    for (std::size_t cause = 0; cause < kMissCauses; ++cause) {
      const auto part = std::min((*pool)[cause], debt);
      (*pool)[cause] -= part;
      debt -= part;
      by_cause_[cause] += part;
    }
  }
  return debt;
}

/// Misses that were thought to be good periods are late outputs where these may have been too late; what is left.
std::uint32_t SyncEventAccount::explain_by_doubt(std::uint32_t debt) {
  auto left = debt;
  const auto take = [&](std::uint32_t& pool, MissCause cause) {
    const auto part = std::min(pool, left);
    pool -= part;
    left -= part;
    at(by_cause_, cause) += part;
  };
  for (auto* doubt : {&doubted_, &doubtful_}) {
    take(doubt->held_up, MissCause::kFrameHeldUp);
    take(doubt->late, MissCause::kFrameLate);
  }
  correct(debt - left);
  return left;
}

/// Good periods that were misses, or, negative, the other way round. A miss is 3 more; what a good period has counted
/// down is given back, which is nothing while there was no error. At its limit the slave gives up, and counts no
/// further.
void SyncEventAccount::correct(std::int64_t misses) {
  const auto back = std::clamp<std::int64_t>(misses, 0, counted_down_);
  counted_down_ -= static_cast<std::uint32_t>(back);
  const auto value = std::int64_t{integrator_} + misses * kMissWeight + (misses < 0 ? misses : back);
  const std::int64_t most = limit_ > 0 ? limit_ + kMissWeight - 1 : UINT16_MAX;
  integrator_ = static_cast<std::uint32_t>(std::clamp<std::int64_t>(value, 0, most));
}

void SyncEventAccount::read(std::uint32_t counter) {
  readable_ = true;
  const bool first = !counter_.known();
  auto told = counter_.read(counter);
  if (first) {
    // What it has counted so far is what was presumed, as far as that goes; the rest is somebody else's.
    told = std::min(counter, sum(presumed_));
    before_first_ += told;
  } else {
    // What was computed for the time between the last reading and the fall is told after all.
    const auto confirmed = std::min(told, computed_);
    computed_ -= confirmed;
    told -= confirmed;
  }
  // Behind the last reading nothing was seen that could explain anything.
  if (!std::exchange(any_since_reading_, false)) {
    unexplained_ += told;
    return;
  }
  // The slave may count a miss before this side has seen its period end: the last reading's are explained now or never.
  const auto never = explain_by_doubt(explain(unexplained_));
  correct(never);
  at(by_cause_, MissCause::kUnknown) += never;
  unexplained_ = explain_by_doubt(explain(told));
  // What was presumed before the last reading, and neither of the two told: those were good periods.
  const auto good = sum(carried_);
  correct(-std::int64_t{good});
  take_back_peaks(good);
  carried_ = std::exchange(presumed_, {});
  doubted_ = std::exchange(doubtful_, {});
  counted_down_ = 0;
  // At its limit it may have fallen, which the next look at its state tells.
  if (limit_ == 0 || std::max(candidate_, earlier_) < limit_) settle_peaks();
}

bool SyncEventAccount::in_doubt() const { return sum(presumed_) + sum(carried_) > 0; }

/// The error counter has not been as high as it was thought to be while `misses` that were none counted: by three for
/// each, and by what the good period that each of them was takes off.
void SyncEventAccount::take_back_peaks(std::uint32_t misses) {
  const auto lower = [&](std::uint32_t peak) { return peak - std::min(peak, misses * (kMissWeight + 1)); };
  const auto before = lower(earlier_);
  // What both readings have confirmed by now stays.
  highest_ = std::max(highest_, limit_ > 0 ? std::min(before, limit_ - 1) : before);
  earlier_ = std::max(lower(candidate_), integrator_);
  candidate_ = integrator_;
}

void SyncEventAccount::settle_peaks() {
  if (in_doubt()) return;
  highest_ = std::max({highest_, candidate_, earlier_});
  candidate_ = integrator_;
  earlier_ = 0;
}

void SyncEventAccount::confirm_op() {
  if (limit_ > 0) {
    for (auto* value : {&integrator_, &candidate_, &earlier_}) *value = std::min(*value, limit_ - 1);
  }
  settle_peaks();
}

void SyncEventAccount::came_back() {
  evaluated_.reset();
  delivered_.reset();
}

void SyncEventAccount::left_op() {
  const auto never = explain_by_doubt(explain(std::exchange(unexplained_, 0)));
  correct(never);
  candidate_ = std::max(candidate_, integrator_);
  at(by_cause_, MissCause::kUnknown) += never;
  computed_ += explain_rest();
  settle_peaks();
}

/// Misses, below the limit.
std::uint32_t SyncEventAccount::missing_to_limit() const {
  return (limit_ - integrator_ + kMissWeight - 1) / kMissWeight;
}

void SyncEventAccount::gave_up_late() {
  if (integrator_ >= limit_) return;
  const auto more = missing_to_limit();
  at(by_cause_, MissCause::kFrameLate) += more;
  take_uncounted(more);
}

bool SyncEventAccount::gave_up_in_doubt() {
  if (integrator_ >= limit_) return false;
  const auto more = missing_to_limit();
  if (doubted_.held_up + doubted_.late + doubtful_.held_up + doubtful_.late < more) return false;
  auto left = more;
  // The latest are those it gave up for.
  for (auto* doubt : {&doubtful_, &doubted_}) {
    for (const auto& [pool, cause] :
         {std::pair{&doubt->late, MissCause::kFrameLate}, std::pair{&doubt->held_up, MissCause::kFrameHeldUp}}) {
      const auto part = std::min(*pool, left);
      *pool -= part;
      left -= part;
      at(by_cause_, cause) += part;
    }
  }
  take_uncounted(more);
  return true;
}

void SyncEventAccount::take_uncounted(std::uint32_t misses) {
  integrator_ += misses * kMissWeight;
  highest_ = std::max(highest_, integrator_);
  computed_ += misses;
  uncounted_ = true;
}

/// What no reading will tell any more is taken as it was presumed; how many.
std::uint32_t SyncEventAccount::explain_rest() {
  const auto rest = sum(presumed_) + sum(carried_);
  (void)explain(rest);
  return rest;
}

void SyncEventAccount::entered_op(const Sync0Grid& grid) {
  grid_ = grid;
  integrator_ = candidate_ = earlier_ = counted_down_ = 0;
  counter_.begin_anew();
  evaluated_.reset();
  delivered_.reset();
  frames_lost_ = held_up_ = left_out_ = 0;
  doubtful_ = doubted_ = {};
}

std::uint32_t SyncEventAccount::missed() const {
  return counter_.total() + before_first_ + computed_ + (readable_ ? 0 : sum(presumed_));
}

std::uint32_t SyncEventAccount::integrator_highest() const {
  return readable_ ? highest_ : std::max({highest_, candidate_, earlier_});
}

MissesByCause SyncEventAccount::by_cause() const {
  auto causes = by_cause_;
  at(causes, MissCause::kUnknown) += unexplained_;
  for (std::size_t cause = 0; !readable_ && cause < kMissCauses; ++cause) causes[cause] += presumed_[cause];
  return causes;
}

std::uint32_t SyncEventAccount::integrator() const { return std::min(integrator_, 0xFFFFU); }

}  // namespace syncline::dc
