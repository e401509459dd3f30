// SPDX-License-Identifier: Apache-2.0
#include "master/sm2_reader.h"

#include <algorithm>

#include "master/sm2_counter_profile.h"
#include "protocol/dc_registers.h"

namespace syncline {
namespace {

/// Often enough for a live plot, seldom enough to leave the slaves' mailboxes to others.
constexpr Nanoseconds kPeriod = 20 * kMillisecond;
constexpr coe::ObjectAddress kSyncErrorLimit{0x10F1, 2};

bool uses_sync(const SlaveConfig& slave) {
  return slave.mailbox && slave.mailbox->coe && slave.dc && AssignActivate{slave.dc->assign_activate}.sync0();
}

}  // namespace

Sm2Reader::Sm2Reader(RunState& run, CyclicMailbox& mailbox) : run_(run), mailbox_(mailbox) {
  for (std::size_t i = 0; i < run.config().slaves.size(); ++i) {
    const auto& slave = run.config().slaves[i];
    if (!uses_sync(slave)) continue;
    const auto known = known_sm2_missed_sub_index(slave.identity);
    counters_.push_back({static_cast<std::uint16_t>(i), known.value_or(kSm2MissedSubIndex), !known});
  }
}

std::vector<std::size_t> Sm2Reader::slaves() const {
  std::vector<std::size_t> slaves;
  for (const auto& counter : counters_) slaves.push_back(counter.slave);
  return slaves;
}

void Sm2Reader::set_sub_index(std::size_t slave, std::uint8_t sub_index) {
  for (auto& counter : counters_) {
    if (counter.slave != slave) continue;
    counter.sub_index = sub_index;
    counter.both = false;
  }
}

void Sm2Reader::begin(Nanoseconds now) {
  if (counters_.empty() || now < next_start_ || !mailbox_.idle()) return;
  next_start_ = now + kPeriod / static_cast<Nanoseconds>(counters_.size());
  current_ = (current_ + 1) % counters_.size();
  auto& counter = counters_[current_];
  const auto state = al_state_of(run_.snapshot.slaves[counter.slave].al_status);
  const bool counting = state == AlState::kSafeop || state == AlState::kOp;
  if (!counter.supported || !counting || !mailbox_.ready_for(counter.slave)) return;
  if (state != AlState::kOp) counter.integrator.reset();  // the slave counts in OP
  if (!counter.limit_known) return mailbox_.upload(counter.slave, kSyncErrorLimit, now);
  counter.other = counter.both && !counter.other;
  mailbox_.upload(counter.slave, {kSyncManager2Parameter, counter.other ? kSm2MissedSubIndexOldLayout : counter.sub_index}, now);
}

void Sm2Reader::take(const CyclicMailbox::Answer& answer, CycleSample& sample) {
  if (counters_.empty() || counters_[current_].slave != answer.slave) return;
  if (answer.object.index == kSyncErrorLimit.index) take_limit(answer);
  if (answer.object.index == kSyncManager2Parameter) take_counter(answer, sample);
}

void Sm2Reader::take_limit(const CyclicMailbox::Answer& answer) {
  auto& counter = counters_[current_];
  counter.limit_known = answer.kind == CyclicMailbox::Answer::Kind::kValue || answer.kind == CyclicMailbox::Answer::Kind::kAbort;
  const bool told = answer.kind == CyclicMailbox::Answer::Kind::kValue;
  run_.snapshot.slaves[counter.slave].sm2_missed.limit = told ? answer.value : 0;
}

std::uint64_t Sm2Reader::sync_cycle(std::size_t slave, std::uint64_t bus_cycle) const {
  const auto bus = run_.config().cycle_time();
  const auto sync = run_.config().slaves[slave].dc->cycle_time0;
  return sync > bus ? bus_cycle / static_cast<std::uint64_t>(sync / bus) : bus_cycle;
}

void Sm2Reader::take_counter(const CyclicMailbox::Answer& answer, CycleSample& sample) {
  auto& counter = counters_[current_];
  auto& status = run_.snapshot.slaves[counter.slave].sm2_missed;
  if (answer.kind == CyclicMailbox::Answer::Kind::kAbort) {
    if (!counter.other) counter.supported = false;
    counter.both = counter.other = false;  // there are not two
  }
  if (answer.kind != CyclicMailbox::Answer::Kind::kValue) return;
  if (counter.other) {
    status.other_sub_index = kSm2MissedSubIndexOldLayout;
    status.other_value = answer.value;
    return;
  }
  if (!counter.both) status.other_sub_index = 0;
  counter.integrator.read(answer.value, sync_cycle(counter.slave, sample.cycle));
  status.valid = true;
  status.value = answer.value;
  status.index = kSyncManager2Parameter;
  status.sub_index = counter.sub_index;
  status.integrator = counter.integrator.value();
  status.integrator_highest = std::max(status.integrator_highest, status.integrator);
  sample.sm2_position = static_cast<std::int16_t>(counter.slave);
  sample.slave_sm2_missed = answer.value;
  sample.slave_sm2_integrator = status.integrator;
}

}  // namespace syncline
