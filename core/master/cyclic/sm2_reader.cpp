// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/sm2_reader.h"

#include <algorithm>
#include <utility>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/slave_evidence.h"
#include "channels/snapshot.h"
#include "config/network_config.h"
#include "config/slave_config.h"
#include "master/cyclic/sync_event_watch.h"
#include "master/exchange/event_teller.h"
#include "master/mailbox/sm2_counter_profile.h"
#include "protocol/assign_activate.h"

namespace syncline {
namespace {

/// Often enough for a live plot, seldom enough to leave the slaves' mailboxes to others.
constexpr Nanoseconds kPeriod = 20 * kMillisecond;
/// A frame that comes sooner than usual by one in so many of the cycle comes too soon for who needs nearly all of it.
constexpr Nanoseconds kCloseShare = 50;
constexpr coe::ObjectAddress kSyncErrorLimit{0x10F1, 2};
constexpr std::uint8_t kCalcAndCopyTime = 0x06, kShiftTooShort = 0x0D, kSyncErrorSubIndex = 0x20;

bool has_objects(const SlaveConfig& slave) { return slave.mailbox && slave.mailbox->coe; }
bool uses_sync(const SlaveConfig& slave) { return slave.dc && AssignActivate{slave.dc->assign_activate}.sync0(); }

std::uint8_t other_of(std::uint8_t sub_index) {
  return sub_index == kSm2MissedSubIndex ? kSm2MissedSubIndexOldLayout : kSm2MissedSubIndex;
}

}  // namespace

Sm2Reader::Sm2Reader(const NetworkConfig& config, Snapshot& snapshot, EventTeller& teller, CyclicMailbox& mailbox,
                     SyncEventWatch& events)
    : config_(config), snapshot_(snapshot), teller_(teller), mailbox_(mailbox), events_(events) {
  for (const bool sync : {true, false}) {
    for (std::size_t i = 0; i < config.slaves.size(); ++i) {
      if (has_objects(config.slaves[i]) && uses_sync(config.slaves[i]) == sync) add(i, sync);
    }
    if (sync) with_sync_ = counters_.size();
  }
}

void Sm2Reader::add(std::size_t position, bool sync) {
  const auto known = known_sm2_missed_sub_index(config_.slaves[position].identity);
  Counter counter;
  counter.slave = static_cast<std::uint16_t>(position);
  counter.missed = known.value_or(kSm2MissedSubIndex);
  counter.exceeded = other_of(counter.missed);
  // As long as nobody knows which of the two it is they are read in turn, and neither is called by its name.
  if (sync) counter.has = static_cast<std::uint16_t>(((1U << kItems) - 1) & ~exceeded());
  if (known) tell_apart(counter);
  counters_.push_back(counter);
}

void Sm2Reader::tell_apart(Counter& counter) {
  counter.has = static_cast<std::uint16_t>((counter.has | exceeded()) & ~bit(Item::kOther));
}

std::vector<std::size_t> Sm2Reader::slaves() const {
  std::vector<std::size_t> slaves;
  for (const auto& counter : counters_) slaves.push_back(counter.slave);
  return slaves;
}

void Sm2Reader::set_sub_index(std::size_t slave, std::uint8_t sub_index) {
  for (auto& counter : counters_) {
    if (counter.slave != slave) continue;
    counter.missed = sub_index;
    counter.exceeded = other_of(sub_index);
    tell_apart(counter);
  }
}

void Sm2Reader::choose(Counter& counter) {
  for (const auto once : {Item::kLimit, Item::kCalcAndCopy}) {
    if ((counter.has & bit(once)) == 0) continue;
    counter.turn = once;
    return;
  }
  if (counter.turn != Item::kMissed && (counter.has & bit(Item::kMissed)) != 0) {
    counter.turn = Item::kMissed;
    return;
  }
  constexpr auto kFirst = static_cast<std::uint8_t>(Item::kOther);
  for (std::uint8_t n = 0; n < kItems - kFirst; ++n) {
    const auto next = static_cast<std::uint8_t>(counter.rare) + 1;
    counter.rare = next == kItems ? Item::kOther : static_cast<Item>(next);
    if ((counter.has & bit(counter.rare)) == 0) continue;
    counter.turn = counter.rare;
    return;
  }
}

coe::ObjectAddress Sm2Reader::object(const Counter& counter) {
  switch (counter.turn) {
    case Item::kLimit:
      return kSyncErrorLimit;
    case Item::kCalcAndCopy:
      return {kSyncManager2Parameter, kCalcAndCopyTime};
    case Item::kMissed:
      return {kSyncManager2Parameter, counter.missed};
    case Item::kOther:
      return {kSyncManager2Parameter, other_of(counter.missed)};
    case Item::kOutputsExceeded:
      return {kSyncManager2Parameter, counter.exceeded};
    case Item::kOutputsShift:
      return {kSyncManager2Parameter, kShiftTooShort};
    case Item::kSyncError:
      return {kSyncManager2Parameter, kSyncErrorSubIndex};
    case Item::kInputsExceeded:
      return {kSyncManager3Parameter, counter.exceeded};
    case Item::kInputsShift:
      return {kSyncManager3Parameter, kShiftTooShort};
  }
  return {};
}

/// Those that run by themselves share one turn: many of them do not make the others' misses known later.
std::size_t Sm2Reader::next() {
  turn_ = (turn_ + 1) % (with_sync_ + (has_others() ? 1 : 0));
  if (turn_ < with_sync_) return turn_;
  other_ = (other_ + 1) % (counters_.size() - with_sync_);
  return with_sync_ + other_;
}

void Sm2Reader::sent(Nanoseconds time, std::optional<Nanoseconds> reference_time, bool late) {
  const auto before = std::exchange(last_passed_, reference_time);
  const auto sent_before = std::exchange(last_sent_, time);
  const auto passed = before && reference_time ? *reference_time - *before : time - sent_before;
  const auto cycle = config_.cycle_time();
  if (late || passed < cycle - cycle / kCloseShare) ++close_;
}

void Sm2Reader::begin(Nanoseconds now) {
  if (counters_.empty() || now < next_start_ || !mailbox_.idle()) return;
  next_start_ = now + kPeriod / static_cast<Nanoseconds>(with_sync_ + (has_others() ? 1 : 0));
  current_ = next();
  auto& counter = counters_[current_];
  const bool counting = has_process_data_communication(al_state_of(snapshot_.slaves[counter.slave].al_status));
  if (!counting || counter.has == 0 || !mailbox_.ready_for(counter.slave)) return;
  choose(counter);
  if ((counter.has & bit(counter.turn)) == 0) return;
  close_when_asked_ = close_;
  mailbox_.upload(counter.slave, object(counter));
}

void Sm2Reader::take(const CyclicMailbox::Answer& answer, Nanoseconds now, CycleSample& sample) {
  using Kind = CyclicMailbox::Answer::Kind;
  if (counters_.empty()) return;
  auto& counter = counters_[current_];
  if (counter.slave != answer.slave || answer.object.index == 0 || answer.object != object(counter)) return;
  const auto item = counter.turn;
  const bool once = item == Item::kLimit || item == Item::kCalcAndCopy;
  if (answer.kind == Kind::kAbort || (once && answer.kind == Kind::kValue)) {
    counter.has = static_cast<std::uint16_t>(counter.has & ~bit(item));
  }
  // There are not two to be mistaken for each other.
  if (answer.kind == Kind::kAbort && item == Item::kOther)
    snapshot_.slaves[counter.slave].sm2_missed.other_sub_index = 0;
  if (answer.kind == Kind::kValue) take_value(counter, answer.value, now, sample);
}

void Sm2Reader::take_value(Counter& counter, std::uint32_t value, Nanoseconds now, CycleSample& sample) {
  auto& slave = snapshot_.slaves[counter.slave];
  auto& evidence = slave.evidence;
  const auto count = [&](EvidenceCount& result, std::size_t which) {
    auto& total = counter.totals[which];
    const auto more = total.read(value);
    result = {total.total(), total.at_least(), now};
    return more;
  };
  const auto exceeded = [&](SyncObjectCounts& counts, std::size_t which) {
    const auto more = count(counts.exceeded, which), not_its_own = by_frames(counter, which, more);
    counts.by_frames += not_its_own;
    tell_exceeded(counter, which, more - not_its_own, now);
  };
  switch (counter.turn) {
    case Item::kLimit:
      slave.sm2_missed.limit = value;
      events_.set_limit(counter.slave, value);
      return;
    case Item::kCalcAndCopy:
      evidence.calc_and_copy_ns = value;
      events_.set_calc_and_copy(counter.slave, value);
      return;
    case Item::kMissed:
      return take_missed(counter, value, now, sample);
    case Item::kOther:
      slave.sm2_missed.other_sub_index = other_of(counter.missed);
      slave.sm2_missed.other_value = value;
      return;
    case Item::kOutputsExceeded:
      return exceeded(evidence.outputs, 0);
    case Item::kOutputsShift:
      count(evidence.outputs.shift_too_short, 1);
      return;
    case Item::kSyncError:
      evidence.outputs.sync_error = value != 0;
      evidence.outputs.sync_error_time = now;
      return;
    case Item::kInputsExceeded:
      return exceeded(evidence.inputs, 2);
    case Item::kInputsShift:
      count(evidence.inputs.shift_too_short, 3);
      return;
  }
}

std::uint32_t Sm2Reader::by_frames(Counter& counter, std::size_t which, std::uint32_t more) const {
  const auto before = std::exchange(counter.close_before[which], close_when_asked_);
  const bool by_sync0 = (counter.has & bit(Item::kMissed)) != 0;
  return by_sync0 ? 0 : static_cast<std::uint32_t>(std::min<std::uint64_t>(more, close_ - before));
}

/// Once when it begins to rise, and once when it has stopped.
void Sm2Reader::tell_exceeded(Counter& counter, std::size_t which, std::uint32_t more, Nanoseconds now) {
  if (std::exchange(counter.rising[which], more > 0) == (more > 0)) return;
  teller_.tell(now, counter.slave, events::LongCycles{more > 0, more});
}

void Sm2Reader::take_missed(const Counter& counter, std::uint32_t value, Nanoseconds now, CycleSample& sample) {
  auto& status = snapshot_.slaves[counter.slave].sm2_missed;
  events_.read(counter.slave, value);
  status.valid = true;
  status.value = value;
  status.time = now;
  status.index = kSyncManager2Parameter;
  status.sub_index = counter.missed;
  // What the slave counted while it found into OP is none of what is followed from there on.
  if (!status.known && events_.follows(counter.slave)) return;
  sample.sm2_position = static_cast<std::int16_t>(counter.slave);
  sample.slave_sm2_missed = status.total();
  sample.slave_sm2_integrator = status.integrator;
}

}  // namespace syncline
