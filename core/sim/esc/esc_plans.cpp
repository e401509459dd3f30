// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <concepts>
#include <cstring>
#include <utility>

#include "protocol/registers.h"
#include "sim/esc/esc.h"
#include "sim/esc/esc_events.h"
#include "sim/registers/esc_ranges.h"
#include "sim/registers/short_copy.h"

/// What the frames of every cycle do to an ESC: found out once, then followed.
namespace syncline::sim {

using namespace esc_events;
using Do = FramePlan::Do;

namespace {

constexpr std::uint16_t kLatchesEnd = 0x0A00;  // of the DC unit, too

/// Apart from the loop over the steps, whose usual ones they would make slower.
[[gnu::noinline]] void copy_any(const std::uint8_t* from, std::uint8_t* to, std::size_t length) {
  short_copy({from, length}, {to, length});
}
[[gnu::noinline]] void or_any(const std::uint8_t* from, std::uint8_t* to, std::size_t length) {
  short_or({from, length}, {to, length});
}

void or_word(const std::uint8_t* from, std::uint8_t* to) {
  const auto bits = load_le<std::uint16_t>({from, 2}) | load_le<std::uint16_t>({to, 2});
  store_le<std::uint16_t>({to, 2}, static_cast<std::uint16_t>(bits));
}

/// Two words that may overlap; `from` and `to` do not.
template <std::unsigned_integral Word>
void copy_two(const std::uint8_t* from, std::uint8_t* to, std::size_t length) {
  const auto last = length - sizeof(Word);
  const auto a = load_le<Word>({from, sizeof(Word)}), b = load_le<Word>({from + last, sizeof(Word)});
  store_le<Word>({to, sizeof(Word)}, a);
  store_le<Word>({to + last, sizeof(Word)}, b);
}

bool process_data_equal(const std::uint8_t* a, const std::uint8_t* b, std::size_t length) {
  constexpr std::size_t kWord = 8;
  if (length <= kWord || length > 4 * kWord) return short_equal({a, length}, {b, length});
  const auto same = [&](std::size_t at) {
    return load_le<std::uint64_t>({a + at, kWord}) == load_le<std::uint64_t>({b + at, kWord});
  };
  // Words that may overlap.
  if (length > 2 * kWord && !(same(kWord) && same(length - 2 * kWord))) return false;
  return same(0) && same(length - kWord);
}

void copy_process_data(const std::uint8_t* from, std::uint8_t* to, std::size_t length) {
  if (length >= 4 && length <= 8) {
    copy_two<std::uint32_t>(from, to, length);
  } else if (length > 8 && length <= 16) {
    copy_two<std::uint64_t>(from, to, length);
  } else if (length > 16 && length <= 32) {
    copy_two<std::uint64_t>(from, to, 16);
    copy_two<std::uint64_t>(from + length - 16, to + length - 16, 16);
  } else {
    copy_any(from, to, length);
  }
}

}  // namespace

const FramePlan* Esc::plan_for(PassingFrame& frame) {
  const auto* shape = frame.shape();
  if (shape == nullptr) return nullptr;
  if (is_called_by(frame)) return nullptr;
  auto& plan = plans_[shape->place];
  if (plan.shape != shape->id || plan.generation != generation_) {
    plan = {.shape = shape->id, .generation = generation_};
    planner_.make(plan, frame);
  }
  return plan.executed ? nullptr : &plan;
}

[[gnu::noinline]] bool Esc::becomes_usual() {
  if (has_something_under_way()) return false;
  events_ = requests_.requested();
  told_events_ = requests_.told();
  as_usual_ = true;
  return true;
}

void Esc::follow(const FramePlan& plan, std::uint8_t* frame, unsigned first) {
  auto* const memory = memory_.at(0, EscMemory::kSize).data();
  const auto* const steps = plan.steps.data();
  const auto* const end = steps + plan.count;
  const auto* step = steps + first;
  for (const auto* const last = steps + plan.takes; step != last; ++step)
    copy_process_data(frame + step->offset, memory + step->address, step->length);
  for (const auto* const last = step + plan.gives; step != last; ++step)
    copy_process_data(memory + step->address, frame + step->offset, step->length);
  for (const auto* const last = step + plan.words; step != last; ++step) {
    or_word(memory + step->address, frame + step->offset);
  }
  for (; step != end; ++step) follow(*step, memory + step->address, frame + step->offset);
  if (plan.difference_offset != 0) or_difference(frame + plan.difference_offset);
  if (plan.told != 0 && !(as_usual_ && events_ == 0)) tell_events(plan.told);
  managers_.pass(plan.written | plan.read);
}

void Esc::or_difference(std::uint8_t* data) const {
  store_le<std::uint32_t>({data, 4}, load_le<std::uint32_t>({data, 4}) | dc_.shown_difference());
}

void Esc::read_buffers(std::uint32_t managers) {
  for (; managers != 0; managers &= managers - 1)
    managers_.buffers().read(static_cast<unsigned>(std::countr_zero(managers)));
}

void Esc::follow(const FramePlan::Step& step, std::uint8_t* memory, std::uint8_t* data) {
  switch (step.what) {
    case Do::kOrRegister:
      return or_any(memory, data, step.length);
    case Do::kGiveRegister:
      return copy_process_data(memory, data, step.length);
    case Do::kGiveBit: {
      const auto place = step.detail & 7U;
      const auto bit = *memory >> (step.detail >> FramePlan::kMemoryBit) & 1U;
      *data = static_cast<std::uint8_t>((*data & ~(1U << place)) | bit << place);
      return;
    }
    case Do::kTakeOutputs:
    case Do::kGiveInputs:
    case Do::kOrWord:
      break;
  }
  __builtin_unreachable();  // in every step of every frame
}

void Esc::open_buffers(const FramePlan& plan) {
  for (const auto& step : std::span(plan.steps).subspan(plan.takes, plan.gives))
    managers_.open(step.address, step.length);
}

void Esc::tell_events(std::uint8_t told) {
  if ((told & FramePlan::kTellsDlStatus) != 0) clear_event(kEventDlStatus);
  if ((told & FramePlan::kTellsAlStatus) != 0) clear_event(kEventAlStatus);
}

/// What process() and frame_end() do one after the other: nobody else sees what happens in between.
[[gnu::flatten]] void Esc::follow_at_once(const FramePlan& plan, PassingFrame& frame, Nanoseconds begin,
                                          Nanoseconds end) {
  frame_time_ = begin;
  frame.add_event(told_events_);
  bool read = false;
  if (plan.time_size != 0 && renewed_by_signal_ != 0) {
    const auto signals = dc_.start_of_counted_frame(begin);
    read = signals == 1 && plan.read == renewed_by_signal_;
    read ? managers_.buffers().write_and_read(plan.read) : renew(renewed_by_signal_, signals);
  } else {
    dc_.pass_quietly(begin);
    if (renewed_by_signal_ != 0) count_renewals();
    if (plan.time_size != 0) dc_.start_of_frame(begin);
  }
  if (!read) read_buffers(plan.read);
  follow_data(plan, frame, end);
  if (((plan.written | plan.read) & minded_) != 0) {
    managers_.set_transfers(plan.written, plan.read);
    end_transfers(end);
  } else {
    if (plan.restarts_watchdog) restart_watchdog(end);
    if ((renewed_by_transfer_.by & plan.written) != 0) renew(renewed_by_transfer_.renewed, 1);
  }
}

[[gnu::flatten]] void Esc::follow_passively(const FramePlan& plan, PassingFrame& frame, Nanoseconds begin,
                                            Nanoseconds end) {
  frame_time_ = begin;
  frame.add_event(told_events_);
  dc_.pass_quietly(end);
  auto* const bytes = frame.bytes().data();
  if (plan.count != 0) {
    follow(plan, bytes);
  } else if (plan.difference_offset != 0) {  // where the process data are in another frame
    or_difference(bytes + plan.difference_offset);
  }
  frame.pass(plan.kind);
}

inline void Esc::follow_data(const FramePlan& plan, PassingFrame& frame, Nanoseconds end, unsigned first) {
  auto* const bytes = frame.bytes().data();
  follow(plan, bytes, first);
  frame.pass(plan.kind);
  dc_.pass_quietly(end);
  if (plan.time_size != 0) dc_.system_time_received(plan.time_size, time_in(plan, bytes), end);
}

[[gnu::flatten]] bool Esc::repeat_at_once(const FramePlan& plan, PassingFrame& frame, bool asked, Nanoseconds begin,
                                          Nanoseconds end) {
  auto& cycles = cycles_;
  const auto moment = dc_.moment(begin);
  auto ahead = dc_.until_sync0(moment);
  const bool sync0_came = ahead <= 0;
  const bool brings_outputs = (plan.written >> cycles.work.outputs & 1U) != 0;
  const bool in_turn = sync0_came ? cycles.awaits_sync0 : !(brings_outputs && cycles.awaits_sync0);
  const Nanoseconds cycle = dc_.settings().cycle0;
  if (sync0_came) ahead += cycle;
  const bool in_time = ahead >= RepeatedCycles::at_most(end - begin + cycles.work.calculation);
  const bool unminded = ((plan.written | plan.read) & minded_) == 0;
  if (!in_turn || !in_time || !unminded) return false;
  if (brings_outputs && !holds_outputs_of(plan, frame)) return false;
  if (sync0_came) {
    cycles.behind_sync0 = moment;
    cycles.sync0 = dc_.pass_sync0();
    cycles.awaits_sync0 = false;
  }
  if (sync0_came && plan.read == cycles.work.renewed) {
    managers_.buffers().write_and_read(plan.read);
  } else {
    if (sync0_came) renew(cycles.work.renewed, 1);
    read_buffers(plan.read);
  }
  if (asked) [[unlikely]]
    answer(frame, begin);
  frame_time_ = begin;
  frame.add_event(told_events_);
  if (plan.time_size != 0) dc_.start_of_frame(moment);
  // Outputs that are held already need not be taken.
  follow_data(plan, frame, end, brings_outputs && plan.takes == 1 ? 1 : 0);
  if (plan.restarts_watchdog) restart_watchdog(end);
  if (brings_outputs) {
    cycles.awaits_sync0 = true;
    cycles.taken_at = end;
    ++cycles.outputs_taken;
  }
  cycles.quiet_from = end;
  // A second SYNC0 without outputs between them is another matter.
  repeat_until(begin + RepeatedCycles::surely(cycles.awaits_sync0 ? ahead + cycle : ahead));
  return true;
}

bool Esc::is_only_asked_by(const PassingFrame& frame) {
  const auto [station, alias] = address();
  const auto behind = frame.is_for_single_slaves() ? std::size_t{0} : frame.shape()->datagrams.size();
  const auto datagrams = frame.datagrams();
  for (std::size_t i = 0; i < datagrams.size(); ++i) {
    const auto& datagram = datagrams[i];
    const bool mine = is_for_station(datagram.command) && (datagram.adp == station || datagram.adp == alias);
    if (mine && (i < behind || !only_reads_registers(datagram))) return false;
  }
  return true;
}

bool Esc::only_reads_registers(const PassingDatagram& datagram) const {
  const auto length = datagram.data.size();
  return datagram.command == Command::kFprd &&
         datagram.ado + length <= std::min<std::size_t>(managers_.begin(), EscMemory::kRegisterEnd) &&
         !overlaps(datagram.ado, length, reg::kLatch0Status, kLatchesEnd - reg::kLatch0Status);
}

[[gnu::noinline]] void Esc::answer(PassingFrame& frame, Nanoseconds begin) {
  frame.add_event(requests_.told());
  dc_.pass_quietly(begin);
  if (renewed_by_signal_ != 0) count_renewals();
  if (frame.touches_clock()) dc_.start_of_frame(begin);
  for (auto& datagram : frame.datagrams()) {
    if (!is_for_station(datagram.command) || !addresses_.has(datagram.adp)) continue;
    if (read_memory(datagram.ado, datagram.data, false)) ++datagram.wkc;
  }
}

inline bool Esc::holds_outputs_of(const FramePlan& plan, PassingFrame& frame) const {
  const auto* step = plan.steps.data();
  while (step->detail != cycles_.work.outputs) ++step;  // the plan has it
  const auto* const held = memory_.at(step->address, 0).data();
  return process_data_equal(frame.bytes().data() + step->offset, held, step->length);
}

std::uint64_t Esc::time_in(const FramePlan& plan, const std::uint8_t* frame) {
  const auto* const data = frame + plan.time_offset;
  return plan.time_size == FramePlan::kWideTime ? load_le<std::uint64_t>({data, FramePlan::kWideTime})
                                                : load_le<std::uint32_t>({data, FramePlan::kNarrowTime});
}

/// What becomes effective at the end of the frame.
void Esc::take_up(const FramePlan& plan, const std::uint8_t* frame) {
  if (plan.time_size != 0) {
    dc_.start_of_frame(frame_time_);
    time_size_ = plan.time_size;
    time_received_ = time_in(plan, frame);
  }
  managers_.add_transfers(plan.written, plan.read);
  touched_ = touched_ || plan.time_size != 0 || (plan.written | plan.read) != 0;
}

}  // namespace syncline::sim
