// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/frame_planner.h"

#include <algorithm>
#include <utility>

#include "protocol/registers.h"
#include "sim/dc/dc_unit.h"
#include "sim/esc/fmmu_unit.h"
#include "sim/esc/passing_frame.h"
#include "sim/esc/station_addresses.h"
#include "sim/esc/sync_managers.h"
#include "sim/registers/esc_memory.h"
#include "sim/registers/esc_ranges.h"
#include "sim/registers/write_protection.h"

namespace syncline::sim {

using Do = FramePlan::Do;

namespace {

constexpr std::uint16_t kClockBegin = reg::kReceiveTimePort0, kClockSize = 0x100;

std::uint8_t status_events(const PassingDatagram& datagram) {
  const bool dl = overlaps(datagram.ado, datagram.data.size(), reg::kDlStatus, 2);
  const bool al = overlaps(datagram.ado, datagram.data.size(), reg::kAlStatus, 2);
  return static_cast<std::uint8_t>((dl ? FramePlan::kTellsDlStatus : 0) | (al ? FramePlan::kTellsAlStatus : 0));
}

}  // namespace

void FramePlanner::make(FramePlan& plan, PassingFrame& frame) const {
  if (protection_.any()) return;
  frame.settle();
  const auto datagrams = std::as_const(frame).datagrams();
  for (std::size_t i = 0; i < datagrams.size(); ++i) {
    const auto offset = static_cast<std::size_t>(datagrams[i].data.data() - frame.bytes().data());
    if (!add_datagram(plan, datagrams[i], i, offset)) return;
  }
  const auto kind = frame.kind_of(plan.wkc);
  if (!kind || plan.depends_on_order()) return;
  plan.kind = *kind;
  plan.executed = false;
  const auto steps = std::span(plan.steps).first(plan.count);
  for (const auto& step : steps) {
    if (step.what == Do::kTakeOutputs) {
      plan.written |= 1U << step.detail;
      const bool watched = (managers_.decoded(step.detail).control & SyncManager::kControlWatchdog) != 0;
      plan.restarts_watchdog = plan.restarts_watchdog || watched;
    }
    if (step.what == Do::kGiveInputs) plan.read |= 1U << step.detail;
  }
}

/// False: somebody must look at it each time.
bool FramePlanner::add_datagram(FramePlan& plan, const PassingDatagram& datagram, std::size_t number,
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
      return datagram.adp != 0 && add_time(plan, datagram, number, offset);
    case Command::kFrmw:
      return !addresses_.has(datagram.adp) && add_time(plan, datagram, number, offset);
    case Command::kBwr:
      return add_time(plan, datagram, number, offset);
    case Command::kBrd:
      return add_reading(plan, datagram, number, offset);
    case Command::kLrd:
    case Command::kLwr:
    case Command::kLrw:
      return add_logical(plan, datagram, number, offset);
    case Command::kBrw:
      break;
  }
  return false;
}

bool FramePlanner::add_reading(FramePlan& plan, const PassingDatagram& datagram, std::size_t number,
                               std::size_t offset) const {
  const auto length = datagram.data.size();
  if (length == 0 || datagram.ado + length > std::min<std::size_t>(managers_.begin(), EscMemory::kRegisterEnd))
    return false;
  const bool shown =
      overlaps(datagram.ado, length, DcUnit::kShownBegin, kClockBegin + kClockSize - DcUnit::kShownBegin);
  const bool difference = datagram.ado == reg::kSystemTimeDifference && length == 4;
  if ((shown && !difference) || overlaps(datagram.ado, length, reg::kSyncManager, reg::kSyncManagersSize)) return false;
  if (!memory_.any_have(EscMemory::kRead, datagram.ado, length)) return true;  // not in this ESC
  if (!memory_.is_readable(datagram.ado, length)) return false;
  plan.wkc[number] = 1;
  if (difference) return std::exchange(plan.difference_offset, static_cast<std::uint16_t>(offset)) == 0;
  const auto what = length == sizeof(std::uint16_t) ? Do::kOrWord : Do::kOrRegister;
  return plan.add({what, status_events(datagram), static_cast<std::uint16_t>(offset), datagram.ado,
                   static_cast<std::uint16_t>(length)});
}

bool FramePlanner::add_time(FramePlan& plan, const PassingDatagram& datagram, std::size_t number,
                            std::size_t offset) const {
  const auto length = datagram.data.size();
  if (datagram.ado != reg::kSystemTime || (length != FramePlan::kNarrowTime && length != FramePlan::kWideTime))
    return false;
  if (reg::kSystemTime + length > managers_.begin()) return false;
  if (!memory_.any_have(EscMemory::kWrite, reg::kSystemTime, length)) return true;  // there is no clock
  const bool wide =
      length == FramePlan::kWideTime && memory_.all_have(EscMemory::kWrite, reg::kSystemTime, FramePlan::kWideTime);
  const auto taken = wide ? FramePlan::kWideTime : FramePlan::kNarrowTime;
  // A second one would have to be kept until the end of the frame, too.
  if (plan.time_size != 0 || !memory_.all_have(EscMemory::kWrite, reg::kSystemTime, taken)) return false;
  plan.wkc[number] = 1;
  plan.time_size = taken;
  plan.time_offset = static_cast<std::uint16_t>(offset);
  return true;
}

bool FramePlanner::add_logical(FramePlan& plan, const PassingDatagram& datagram, std::size_t number,
                               std::size_t offset) const {
  const bool both = datagram.command == Command::kLrw;
  if (both && !logical_read_write_) return true;
  const auto planned = [&](std::span<const FmmuUnit::Mapping> mappings, bool writing, unsigned counts) {
    const auto before = plan.count;
    for (const auto& mapping : mappings) {
      if (!add_mapping(plan, datagram, mapping, writing, offset)) return false;
    }
    if (plan.count > before) plan.wkc[number] = static_cast<std::uint16_t>(plan.wkc[number] + counts);
    return true;
  };
  // The write side takes the bytes as they came in; the read side replaces them afterwards.
  const unsigned written = both ? 2 : 1;
  return (datagram.command == Command::kLrd || planned(fmmus_.writing(), true, written)) &&
         (datagram.command == Command::kLwr || planned(fmmus_.reading(), false, 1));
}

/// False: what the mapping does depends on more than the settings, or is not done in one step.
bool FramePlanner::add_mapping(FramePlan& plan, const PassingDatagram& datagram, const FmmuUnit::Mapping& mapping,
                               bool writing, std::size_t offset) const {
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
  if (writing || behind > std::min<std::uint64_t>(managers_.begin(), EscMemory::kRegisterEnd)) return false;
  if (overlaps(address, behind - address, kClockBegin, kClockSize)) return false;
  if (bits == 1 ? ThreeBuffers::shows(address, static_cast<unsigned>(physical % 8))
                : overlaps(address, behind - address, reg::kSyncManager, reg::kSyncManagersSize))
    return false;
  if (bits == 1) {
    const auto places = static_cast<std::uint8_t>((from - begin) % 8 | (physical % 8) << FramePlan::kMemoryBit);
    return plan.add({Do::kGiveBit, places, place, static_cast<std::uint16_t>(address), 1});
  }
  if (from % 8 != 0 || physical % 8 != 0 || bits % 8 != 0) return false;
  return plan.add(
      {Do::kGiveRegister, 0, place, static_cast<std::uint16_t>(address), static_cast<std::uint16_t>(bits / 8)});
}

}  // namespace syncline::sim
