// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
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
constexpr unsigned kMemoryBit = 4;                                    // detail of kGiveBit
constexpr std::uint8_t kNarrowTime = 4, kWideTime = 8;                // bytes

std::uint8_t status_events(const PassingDatagram& datagram) {
  const bool dl = overlaps(datagram.ado, datagram.data.size(), reg::kDlStatus, 2);
  const bool al = overlaps(datagram.ado, datagram.data.size(), reg::kAlStatus, 2);
  return static_cast<std::uint8_t>((dl ? kTellsDlStatus : 0) | (al ? kTellsAlStatus : 0));
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

void Esc::follow(const FramePlan& plan, std::span<std::uint8_t> frame) {
  auto* const begin = frame.data();
  auto* const memory = memory_.at(0, EscMemory::kSize).data();
  const auto* const end = plan.steps.data() + plan.count;
  for (const auto* step = plan.steps.data(); step != end; ++step) follow(*step, memory, begin + step->offset);
}

void Esc::follow(const FramePlan::Step& step, std::uint8_t* memory, std::uint8_t* data) {
  const std::span in_frame(data, step.length);
  const std::span in_memory(memory + step.address, step.length);
  switch (step.what) {
    case Do::kOrRegister:
      short_or(in_memory, in_frame);
      if ((step.detail & kTellsDlStatus) != 0) clear_event(kEventDlStatus);
      if ((step.detail & kTellsAlStatus) != 0) clear_event(kEventAlStatus);
      return;
    case Do::kOrDifference:
      store_le(in_frame, load_le<std::uint32_t>(in_frame) | dc_.shown_difference());
      return;
    case Do::kTakeTime:
      return take_time(data, static_cast<std::uint8_t>(step.length));
    case Do::kTakeOutputs:
      short_copy(in_frame, in_memory);
      touched_ = true;
      return end_transfer(step.detail, true);
    case Do::kGiveInputs:
      if (any_pending_) open_buffer(step.address, step.length);
      short_copy(in_memory, in_frame);
      touched_ = true;
      return end_transfer(step.detail, false);
    case Do::kGiveRegister:
      short_copy(in_memory, in_frame);
      return;
    case Do::kGiveBit: {
      const auto place = step.detail & 7U;
      const auto bit = memory_.u8(step.address) >> (step.detail >> kMemoryBit) & 1U;
      data[0] = static_cast<std::uint8_t>((data[0] & ~(1U << place)) | bit << place);
      return;
    }
  }
  __builtin_unreachable();  // in every step of every frame
}

void Esc::take_time(const std::uint8_t* data, std::uint8_t length) {
  touched_ = true;
  dc_.start_of_frame(frame_time_);
  if (time_size_ != 0) shadow_time();
  if (!writes_.empty()) {  // in the order in which they came
    writes_.push_back({reg::kSystemTime, length});
    std::memcpy(shadow_.data() + shadow_size_, data, length);
    shadow_size_ += length;
    return;
  }
  time_size_ = length;
  time_received_ =
      length == kWideTime ? load_le<std::uint64_t>({data, kWideTime}) : load_le<std::uint32_t>({data, kNarrowTime});
}

void Esc::shadow_time() {
  const auto bytes = le_bytes(time_received_);
  writes_.push_back({reg::kSystemTime, time_size_});
  std::copy_n(bytes.begin(), time_size_, shadow_.begin() + static_cast<std::ptrdiff_t>(shadow_size_));
  shadow_size_ += std::exchange(time_size_, std::uint8_t{0});
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
  plan.executed = false;
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
  if (shown && !difference) return false;
  if (!any_have(EscMemory::kRead, datagram.ado, length)) return true;  // not in this ESC
  if (!is_readable(datagram.ado, length)) return false;
  plan.wkc[number] = 1;
  return plan.add({difference ? Do::kOrDifference : Do::kOrRegister, status_events(datagram),
                   static_cast<std::uint16_t>(offset), datagram.ado, static_cast<std::uint16_t>(length)});
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
  plan.wkc[number] = 1;
  return memory_.all_have(EscMemory::kWrite, reg::kSystemTime, taken) &&
         plan.add({Do::kTakeTime, 0, static_cast<std::uint16_t>(offset), reg::kSystemTime, taken});
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
  if (bits == 1) {
    const auto places = static_cast<std::uint8_t>((from - begin) % 8 | (physical % 8) << kMemoryBit);
    return plan.add({Do::kGiveBit, places, place, static_cast<std::uint16_t>(address), 1});
  }
  if (from % 8 != 0 || physical % 8 != 0 || bits % 8 != 0) return false;
  return plan.add(
      {Do::kGiveRegister, 0, place, static_cast<std::uint16_t>(address), static_cast<std::uint16_t>(bits / 8)});
}

}  // namespace syncline::sim
