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

constexpr std::uint16_t kClockBegin = reg::kReceiveTimePort0, kClockSize = 0x100;
constexpr std::uint8_t kTellsDlStatus = 0x01, kTellsAlStatus = 0x02;  // detail of kOrRegister
constexpr std::uint16_t kLatchesEnd = 0x0A00;                         // of the DC unit, too
constexpr unsigned kMemoryBit = 4;                                    // detail of kGiveBit
constexpr std::uint8_t kNarrowTime = 4, kWideTime = 8;                // bytes

std::uint8_t status_events(const PassingDatagram& datagram) {
  const bool dl = overlaps(datagram.ado, datagram.data.size(), reg::kDlStatus, 2);
  const bool al = overlaps(datagram.ado, datagram.data.size(), reg::kAlStatus, 2);
  return static_cast<std::uint8_t>((dl ? kTellsDlStatus : 0) | (al ? kTellsAlStatus : 0));
}

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

// ---- in each frame ------------------------------------------------------------------------------

const FramePlan* Esc::plan_for(PassingFrame& frame) {
  const auto* shape = frame.shape();
  if (shape == nullptr) return nullptr;
  if (is_called_by(frame)) return nullptr;
  auto& plan = plans_[shape->place];
  if (plan.shape != shape->id || plan.generation != generation_) {
    plan = {.shape = shape->id, .generation = generation_};
    make_plan(plan, frame);
  }
  return plan.executed ? nullptr : &plan;
}

[[gnu::noinline]] bool Esc::becomes_usual() {
  if (has_something_under_way()) return false;
  events_ = memory_.u16(reg::kEcatEventRequest);
  told_events_ = static_cast<std::uint16_t>(events_ & memory_.u16(reg::kEcatEventMask));
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
  sm_begun_ &= ~(plan.written | plan.read);
}

void Esc::or_difference(std::uint8_t* data) const {
  store_le<std::uint32_t>({data, 4}, load_le<std::uint32_t>({data, 4}) | dc_.shown_difference());
}

void Esc::read_buffers(std::uint32_t managers) {
  for (; managers != 0; managers &= managers - 1) buffers_.read(static_cast<unsigned>(std::countr_zero(managers)));
}

void Esc::follow(const FramePlan::Step& step, std::uint8_t* memory, std::uint8_t* data) {
  switch (step.what) {
    case Do::kOrRegister:
      return or_any(memory, data, step.length);
    case Do::kGiveRegister:
      return copy_process_data(memory, data, step.length);
    case Do::kGiveBit: {
      const auto place = step.detail & 7U;
      const auto bit = *memory >> (step.detail >> kMemoryBit) & 1U;
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
  for (const auto& step : std::span(plan.steps).subspan(plan.takes, plan.gives)) open_buffer(step.address, step.length);
}

void Esc::tell_events(std::uint8_t told) {
  if ((told & kTellsDlStatus) != 0) clear_event(kEventDlStatus);
  if ((told & kTellsAlStatus) != 0) clear_event(kEventAlStatus);
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
    read ? buffers_.write_and_read(plan.read) : renew(renewed_by_signal_, signals);
  } else {
    dc_.pass_quietly(begin);
    if (renewed_by_signal_ != 0) count_renewals();
    if (plan.time_size != 0) dc_.start_of_frame(begin);
  }
  if (!read) read_buffers(plan.read);
  follow_data(plan, frame, end);
  if (((plan.written | plan.read) & minded_) != 0) {
    sm_written_ = plan.written;
    sm_read_ = plan.read;
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
    buffers_.write_and_read(plan.read);
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
         datagram.ado + length <= std::min<std::size_t>(buffers_begin_, EscMemory::kRegisterEnd) &&
         !overlaps(datagram.ado, length, reg::kLatch0Status, kLatchesEnd - reg::kLatch0Status);
}

[[gnu::noinline]] void Esc::answer(PassingFrame& frame, Nanoseconds begin) {
  frame.add_event(static_cast<std::uint16_t>(memory_.u16(reg::kEcatEventRequest) & memory_.u16(reg::kEcatEventMask)));
  dc_.pass_quietly(begin);
  if (renewed_by_signal_ != 0) count_renewals();
  if (frame.touches_clock()) dc_.start_of_frame(begin);
  for (auto& datagram : frame.datagrams()) {
    if (!is_for_station(datagram.command) || !has_address(datagram.adp)) continue;
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
  return plan.time_size == kWideTime ? load_le<std::uint64_t>({data, kWideTime})
                                     : load_le<std::uint32_t>({data, kNarrowTime});
}

/// What becomes effective at the end of the frame.
void Esc::take_up(const FramePlan& plan, const std::uint8_t* frame) {
  if (plan.time_size != 0) {
    dc_.start_of_frame(frame_time_);
    time_size_ = plan.time_size;
    time_received_ = time_in(plan, frame);
  }
  sm_written_ |= plan.written;
  sm_read_ |= plan.read;
  touched_ = touched_ || plan.time_size != 0 || (plan.written | plan.read) != 0;
}

// ---- once ---------------------------------------------------------------------------------------

void Esc::make_plan(FramePlan& plan, PassingFrame& frame) const {
  if (protection_.any()) return;
  frame.settle();
  const auto datagrams = std::as_const(frame).datagrams();
  for (std::size_t i = 0; i < datagrams.size(); ++i) {
    const auto offset = static_cast<std::size_t>(datagrams[i].data.data() - frame.bytes().data());
    if (!plan_datagram(plan, datagrams[i], i, offset)) return;
  }
  const auto kind = frame.kind_of(plan.wkc);
  if (!kind || plan.depends_on_order()) return;
  plan.kind = *kind;
  plan.executed = false;
  const auto steps = std::span(plan.steps).first(plan.count);
  for (const auto& step : steps) {
    if (step.what == Do::kTakeOutputs) {
      plan.written |= 1U << step.detail;
      const bool watched = (sync_managers_[step.detail].control & SyncManager::kControlWatchdog) != 0;
      plan.restarts_watchdog = plan.restarts_watchdog || watched;
    }
    if (step.what == Do::kGiveInputs) plan.read |= 1U << step.detail;
  }
}

/// False: somebody must look at it each time.
bool Esc::plan_datagram(FramePlan& plan, const PassingDatagram& datagram, std::size_t number,
                        std::size_t offset) const {
  switch (datagram.command) {
    case Command::kNop:
    case Command::kFprd:
    case Command::kFpwr:
    case Command::kFprw:
      return true;  // who has the address makes no plan
    case Command::kAprd:
    case Command::kApwr:
    case Command::kAprw:
      return datagram.adp != 0;
    case Command::kArmw:
      return datagram.adp != 0 && plan_time(plan, datagram, number, offset);
    case Command::kFrmw:
      return !has_address(datagram.adp) && plan_time(plan, datagram, number, offset);
    case Command::kBwr:
      return plan_time(plan, datagram, number, offset);
    case Command::kBrd:
      return plan_reading(plan, datagram, number, offset);
    case Command::kLrd:
    case Command::kLwr:
    case Command::kLrw:
      return plan_logical(plan, datagram, number, offset);
    case Command::kBrw:
      break;
  }
  return false;
}

bool Esc::plan_reading(FramePlan& plan, const PassingDatagram& datagram, std::size_t number, std::size_t offset) const {
  const auto length = datagram.data.size();
  if (length == 0 || datagram.ado + length > std::min<std::size_t>(buffers_begin_, EscMemory::kRegisterEnd))
    return false;
  const bool shown =
      overlaps(datagram.ado, length, DcUnit::kShownBegin, kClockBegin + kClockSize - DcUnit::kShownBegin);
  const bool difference = datagram.ado == reg::kSystemTimeDifference && length == 4;
  if ((shown && !difference) || overlaps(datagram.ado, length, reg::kSyncManager, reg::kSyncManagersSize)) return false;
  if (!any_have(EscMemory::kRead, datagram.ado, length)) return true;  // not in this ESC
  if (!is_readable(datagram.ado, length)) return false;
  plan.wkc[number] = 1;
  if (difference) return std::exchange(plan.difference_offset, static_cast<std::uint16_t>(offset)) == 0;
  const auto what = length == sizeof(std::uint16_t) ? Do::kOrWord : Do::kOrRegister;
  return plan.add({what, status_events(datagram), static_cast<std::uint16_t>(offset), datagram.ado,
                   static_cast<std::uint16_t>(length)});
}

bool Esc::any_have(std::uint8_t right, std::uint16_t address, std::size_t length) const {
  for (std::size_t i = 0; i < length; ++i) {
    if ((memory_.rights(static_cast<std::uint32_t>(address + i)) & right) != 0) return true;
  }
  return false;
}

bool Esc::plan_time(FramePlan& plan, const PassingDatagram& datagram, std::size_t number, std::size_t offset) const {
  const auto length = datagram.data.size();
  if (datagram.ado != reg::kSystemTime || (length != kNarrowTime && length != kWideTime)) return false;
  if (reg::kSystemTime + length > buffers_begin_) return false;
  if (!any_have(EscMemory::kWrite, reg::kSystemTime, length)) return true;  // there is no clock
  const bool wide = length == kWideTime && memory_.all_have(EscMemory::kWrite, reg::kSystemTime, kWideTime);
  const auto taken = wide ? kWideTime : kNarrowTime;
  // A second one would have to be kept until the end of the frame, too.
  if (plan.time_size != 0 || !memory_.all_have(EscMemory::kWrite, reg::kSystemTime, taken)) return false;
  plan.wkc[number] = 1;
  plan.time_size = taken;
  plan.time_offset = static_cast<std::uint16_t>(offset);
  return true;
}

bool Esc::plan_logical(FramePlan& plan, const PassingDatagram& datagram, std::size_t number, std::size_t offset) const {
  const bool both = datagram.command == Command::kLrw;
  if (both && !options_.logical_read_write) return true;
  const auto planned = [&](std::span<const Mapping> mappings, bool writing, unsigned counts) {
    const auto before = plan.count;
    for (const auto& mapping : mappings) {
      if (!plan_mapping(plan, datagram, mapping, writing, offset)) return false;
    }
    if (plan.count > before) plan.wkc[number] = static_cast<std::uint16_t>(plan.wkc[number] + counts);
    return true;
  };
  // The write side takes the bytes as they came in; the read side replaces them afterwards.
  const unsigned written = both ? 2 : 1;
  return (datagram.command == Command::kLrd || planned(write_mappings_, true, written)) &&
         (datagram.command == Command::kLwr || planned(read_mappings_, false, 1));
}

/// False: what the mapping does depends on more than the settings, or is not done in one step.
bool Esc::plan_mapping(FramePlan& plan, const PassingDatagram& datagram, const Mapping& mapping, bool writing,
                       std::size_t offset) const {
  const auto& fmmu = mapping.fmmu;
  const std::uint64_t begin = 8ULL * datagram.address, end = begin + 8 * datagram.data.size();
  const std::uint64_t first = 8ULL * fmmu.logical_start + fmmu.logical_start_bit;
  const auto from = std::max(first, begin), to = std::min(first + fmmu.bit_length(), end);
  if (from >= to) return true;
  const auto place = static_cast<std::uint16_t>(offset + (from - begin) / 8);
  if (mapping.whole_buffer && from == first && to == first + 8ULL * fmmu.length) {
    if (fmmu.physical_start < EscMemory::kRegisterEnd) return false;
    return plan.add({writing ? Do::kTakeOutputs : Do::kGiveInputs, static_cast<std::uint8_t>(*mapping.whole_buffer),
                     place, fmmu.physical_start, fmmu.length});
  }
  const std::uint64_t physical = 8ULL * fmmu.physical_start + fmmu.physical_start_bit + (from - first);
  const auto address = static_cast<std::uint32_t>(physical / 8);
  const auto bits = to - from;
  const auto behind = (physical + bits + 7) / 8;
  if (writing || behind > std::min<std::uint64_t>(buffers_begin_, EscMemory::kRegisterEnd)) return false;
  if (overlaps(address, behind - address, kClockBegin, kClockSize)) return false;
  if (bits == 1 ? ThreeBuffers::shows(address, static_cast<unsigned>(physical % 8))
                : overlaps(address, behind - address, reg::kSyncManager, reg::kSyncManagersSize))
    return false;
  if (bits == 1) {
    const auto places = static_cast<std::uint8_t>((from - begin) % 8 | (physical % 8) << kMemoryBit);
    return plan.add({Do::kGiveBit, places, place, static_cast<std::uint16_t>(address), 1});
  }
  if (from % 8 != 0 || physical % 8 != 0 || bits % 8 != 0) return false;
  return plan.add(
      {Do::kGiveRegister, 0, place, static_cast<std::uint16_t>(address), static_cast<std::uint16_t>(bits / 8)});
}

}  // namespace syncline::sim
