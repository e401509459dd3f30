// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/sync_object.h"

#include <algorithm>

namespace syncline::sim {
namespace {

constexpr std::uint8_t kType = 0x01, kCycle = 0x02, kShift = 0x03, kSupported = 0x04, kMinimumCycle = 0x05,
                       kCalcAndCopy = 0x06, kMinimumDelay = 0x07, kGetCycleTime = 0x08, kDelay = 0x09, kSync0Cycle = 0x0A,
                       kShiftTooShort = 0x0D, kSyncError = 0x20;
constexpr std::uint16_t kMeasure = 1;
constexpr std::uint16_t kBoolean = 0x0001;  // ETG.1000.6, table 64

}  // namespace

SyncObject::SyncObject(ObjectDictionary& dictionary, std::uint16_t index, const SyncHabits& habits)
    : dictionary_(dictionary), index_(index), habits_(habits), noise_(index) {
  // What the ESI describes is replaced: these values are the simulation's.
  dictionary_.remove_object(index);
  add_entries(index == kOutputs ? "SM output parameter" : "SM input parameter");
}

void SyncObject::add_entries(const char* name) {
  auto& d = dictionary_;
  d.set_object_name(index_, name);
  d.add<std::uint8_t>(index_, 0, "Number of entries", kSyncError);
  auto& type = d.add<std::uint16_t>(index_, kType, "Synchronization type", 0, true);
  type.preop_only = true;
  type.on_write = [this](std::span<const std::uint8_t> data) {
    return supports(static_cast<SyncType>(load_le<std::uint16_t>(data))) ? abort::kNone : abort::kRange;
  };
  // With a local timer or the SyncManager as trigger, the master tells its cycle; with SYNC signals they do.
  d.add<std::uint32_t>(index_, kCycle, "Cycle time", 0, true).preop_only = true;
  d.add<std::uint32_t>(index_, kShift, "Shift time", 0, (habits_.supported & SyncHabits::kLocalShift) != 0).preop_only = true;
  d.add<std::uint16_t>(index_, kSupported, "Synchronization types supported", habits_.supported);
  d.add<std::uint32_t>(index_, kMinimumCycle, "Minimum cycle time", habits_.minimum_cycle);
  d.add<std::uint32_t>(index_, kCalcAndCopy, "Calc and copy time", habits_.calc_and_copy);
  d.add<std::uint32_t>(index_, kMinimumDelay, "Minimum delay time", habits_.delay / 2);
  const bool measures = (habits_.supported & SyncHabits::kMeasures) != 0;
  auto& command = d.add<std::uint16_t>(index_, kGetCycleTime, "Get cycle time", 0, measures);
  command.on_write = [this](std::span<const std::uint8_t> data) { return start_measurement(data); };
  d.add<std::uint32_t>(index_, kDelay, "Maximum delay time", habits_.delay);
  d.add<std::uint32_t>(index_, kSync0Cycle, "Sync0 cycle time", 0);
  d.add<std::uint16_t>(index_, habits_.missed_sub_index, "SM event missed counter", 0);
  d.add<std::uint16_t>(index_, habits_.exceeded_sub_index, "Cycle exceeded counter", 0);
  d.add<std::uint16_t>(index_, kShiftTooShort, "Shift too short counter", 0);
  auto& error = d.add<std::uint8_t>(index_, kSyncError, "Sync error", 0);
  error.data_type = kBoolean;
  error.bit_length = 1;
}

bool SyncObject::supports(SyncType type) const {
  switch (type) {
    case SyncType::kFreeRun: return (habits_.supported & SyncHabits::kFreeRun) != 0;
    case SyncType::kOwnSyncManager: return (habits_.supported & SyncHabits::kSyncManager) != 0;
    case SyncType::kSync0: return (habits_.supported & SyncHabits::kSync0) != 0;
    case SyncType::kSync1: return (habits_.supported & SyncHabits::kSync1) != 0;
    case SyncType::kSyncManager2: return index_ == kInputs && (habits_.supported & SyncHabits::kSyncManager) != 0;
  }
  return false;
}

SyncType SyncObject::type() { return static_cast<SyncType>(dictionary_.get<std::uint16_t>(index_, kType)); }
void SyncObject::set_type(SyncType type) { dictionary_.set(index_, kType, static_cast<std::uint16_t>(type)); }
std::uint32_t SyncObject::cycle() { return dictionary_.get<std::uint32_t>(index_, kCycle); }
void SyncObject::set_cycle(std::uint32_t ns) { dictionary_.set(index_, kCycle, ns); }
void SyncObject::set_sync0_cycle(std::uint32_t ns) { dictionary_.set(index_, kSync0Cycle, ns); }
std::uint32_t SyncObject::shift() { return dictionary_.get<std::uint32_t>(index_, kShift); }
std::uint16_t SyncObject::missed() { return dictionary_.get<std::uint16_t>(index_, habits_.missed_sub_index); }
void SyncObject::count_shift_too_short() { count(kShiftTooShort); }
void SyncObject::set_sync_error(bool error) { dictionary_.set<std::uint8_t>(index_, kSyncError, error ? 1 : 0); }

void SyncObject::count(std::uint8_t sub_index) {
  const auto value = dictionary_.get<std::uint16_t>(index_, sub_index);
  dictionary_.set(index_, sub_index, static_cast<std::uint16_t>(value + 1));
}

void SyncObject::clear_counters() {
  for (const auto sub_index : {habits_.missed_sub_index, habits_.exceeded_sub_index, kShiftTooShort}) {
    dictionary_.set<std::uint16_t>(index_, sub_index, 0);
  }
  set_sync_error(false);
}

std::uint32_t SyncObject::start_measurement(std::span<const std::uint8_t> data) {
  const auto command = load_le<std::uint16_t>(data);
  if (command > kMeasure) return abort::kRange;
  measuring_ = command == kMeasure;
  if (measuring_) {
    for (const auto sub_index : {kMinimumCycle, kCalcAndCopy, kDelay}) dictionary_.set<std::uint32_t>(index_, sub_index, 0);
  }
  return abort::kNone;
}

/// Up to a quarter below the worst case.
Nanoseconds SyncObject::vary(std::uint32_t worst) {
  noise_ = noise_ * 1'664'525U + 1'013'904'223U;
  return worst - (noise_ >> 16) * static_cast<Nanoseconds>(worst / 4) / 0xFFFF;
}

SyncObject::LocalTimes SyncObject::next_cycle(Nanoseconds extra) {
  const LocalTimes times{vary(habits_.calc_and_copy) + extra, vary(habits_.delay)};
  if (measuring_) {
    const auto note = [this](std::uint8_t sub_index, Nanoseconds value) {
      const auto largest = std::max(dictionary_.get<std::uint32_t>(index_, sub_index), static_cast<std::uint32_t>(value));
      dictionary_.set(index_, sub_index, largest);
    };
    note(kCalcAndCopy, times.calc_and_copy);
    note(kDelay, times.delay);
    note(kMinimumCycle, times.calc_and_copy + times.delay);
  }
  return times;
}

}  // namespace syncline::sim
