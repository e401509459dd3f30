// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/sync_object.h"

#include <algorithm>
#include <string>

namespace syncline::sim {
namespace {

constexpr std::uint8_t kType = 0x01, kCycle = 0x02, kShift = 0x03, kSupported = 0x04, kMinimumCycle = 0x05,
                       kCalcAndCopy = 0x06, kMinimumDelay = 0x07, kGetCycleTime = 0x08, kDelay = 0x09,
                       kSync0Cycle = 0x0A, kSyncError = 0x20;
constexpr std::uint16_t kMeasure = 1;
constexpr std::uint16_t kBoolean = 0x0001;  // ETG.1000.6, table 64

}  // namespace

SyncHabits::SyncHabits(const families::Family& family, std::uint16_t supported_bits, std::uint32_t minimum)
    : supported(supported_bits),
      minimum_cycle(minimum),
      calc_and_copy(static_cast<std::uint32_t>(family.times->calc_and_copy)),
      delay(static_cast<std::uint32_t>(family.times->delay)),
      counters(*family.counters),
      types(family.sync_types) {}

SyncObject::SyncObject(ObjectDictionary& dictionary, std::uint16_t index, const SyncHabits& habits)
    : dictionary_(dictionary), index_(index), habits_(habits), noise_(index) {
  // What the ESI describes is replaced: these values are the simulation's.
  dictionary_.remove_object(index);
  add_entries(index == kOutputs ? "SM output parameter" : "SM input parameter");
}

void SyncObject::add_entries(const char* name) {
  auto& d = dictionary_;
  const auto word = [&](std::uint8_t sub_index, std::string_view text,
                        std::uint16_t value) -> ObjectDictionary::Entry& {
    return d.add<std::uint16_t>(index_, sub_index, std::string(text), value);
  };
  const auto time = [&](std::uint8_t sub_index, std::string_view text, std::uint32_t value, bool writable = false) {
    auto& entry = d.add<std::uint32_t>(index_, sub_index, std::string(text), value, writable);
    entry.preop_only = true;
    return ObjectValue<std::uint32_t>(entry);
  };
  d.set_object_name(index_, name);
  d.add<std::uint8_t>(index_, 0, "Number of entries", kSyncError);
  const bool outputs = index_ == kOutputs;
  auto& type = word(kType, "Synchronization type", outputs ? habits_.types.usual_outputs : habits_.types.usual_inputs);
  type.writable = habits_.types.writable;
  type.preop_only = true;
  type.on_write = [this](std::span<const std::uint8_t> data) {
    if (!supports(load_le<std::uint16_t>(data))) return abort::kRange;
    type_told_ = true;
    return abort::kNone;
  };
  type_ = ObjectValue<std::uint16_t>(type);
  cycle_ = time(kCycle, "Cycle time", 0, habits_.cycle_writable);
  d.find(index_, kCycle)->on_write = [this](std::span<const std::uint8_t> data) {
    told_cycle_ = load_le<std::uint32_t>(data);
    return abort::kNone;
  };
  shift_ = time(kShift, "Shift time", 0, !outputs && (habits_.supported & SyncHabits::kLocalShift) != 0);
  word(kSupported, "Synchronization types supported", habits_.supported);
  minimum_cycle_ = time(kMinimumCycle, "Minimum cycle time", habits_.minimum_cycle);
  calc_and_copy_ = time(kCalcAndCopy, "Calc and copy time", habits_.calc_and_copy);
  time(kMinimumDelay, "Minimum delay time", habits_.delay / 2);
  auto& command = word(kGetCycleTime, "Get cycle time", 0);
  command.writable = (habits_.supported & SyncHabits::kMeasures) != 0;
  command.on_write = [this](std::span<const std::uint8_t> data) { return start_measurement(data); };
  delay_ = time(kDelay, habits_.delay_name, habits_.delay);
  sync0_cycle_ = time(kSync0Cycle, "Sync0 cycle time", 0);
  const auto counter = [&](std::uint8_t sub_index, std::string_view text) {
    return sub_index == 0 ? std::nullopt : std::optional(ObjectValue<std::uint16_t>(word(sub_index, text, 0)));
  };
  missed_ = counter(habits_.counters.missed, habits_.missed_name);
  exceeded_ = counter(habits_.counters.cycle_exceeded, habits_.exceeded_name);
  shift_too_short_ = counter(habits_.counters.shift_too_short, habits_.too_short_name);
  auto& error = d.add<std::uint8_t>(index_, kSyncError, "Sync error", 0);
  error.data_type = kBoolean;
  error.bit_length = 1;
  sync_error_ = ObjectValue<std::uint8_t>(error);
}

bool SyncObject::supports(std::uint16_t type) const {
  const auto types = index_ == kOutputs ? habits_.types.outputs : habits_.types.inputs;
  return std::ranges::find(types, type) != types.end();
}

void SyncObject::clear_counters() {
  for (auto* counter : {&missed_, &exceeded_, &shift_too_short_}) {
    if (*counter) (*counter)->set(0);
  }
  set_sync_error(false);
}

std::uint32_t SyncObject::start_measurement(std::span<const std::uint8_t> data) {
  const auto command = load_le<std::uint16_t>(data);
  if (command > kMeasure) return abort::kRange;
  measuring_ = command == kMeasure;
  if (measuring_) {
    for (auto* value : {&minimum_cycle_, &calc_and_copy_, &delay_}) value->set(0);
  }
  return abort::kNone;
}

/// Up to a quarter below the worst case.
Nanoseconds SyncObject::vary(std::uint32_t worst) {
  next_noise();
  return worst - (noise_ >> 16) * static_cast<Nanoseconds>(worst / 4) / 0xFFFF;
}

SyncObject::LocalTimes SyncObject::pass_cycles(std::uint64_t count, Nanoseconds extra) {
  if (measuring_) {
    for (; count > 1; --count) (void)next_cycle(extra);
  } else {
    skip_noise(2 * (count - 1));  // both times of each
  }
  return next_cycle(extra);
}

/// What a step does twice is a step, too, of another factor and sum.
void SyncObject::skip_noise(std::uint64_t times) {
  std::uint32_t factor = kNoiseFactor, sum = kNoiseSum;
  for (; times != 0; times >>= 1) {
    if ((times & 1U) != 0) noise_ = noise_ * factor + sum;
    sum *= factor + 1;
    factor *= factor;
  }
}

SyncObject::LocalTimes SyncObject::next_cycle(Nanoseconds extra) {
  const LocalTimes times{vary(habits_.calc_and_copy) + extra, vary(habits_.delay)};
  if (measuring_) {
    const auto note = [](ObjectValue<std::uint32_t>& largest, Nanoseconds value) {
      largest.set(std::max(largest.get(), static_cast<std::uint32_t>(value)));
    };
    note(calc_and_copy_, times.calc_and_copy);
    note(delay_, times.delay);
    note(minimum_cycle_, times.calc_and_copy + times.delay);
  }
  return times;
}

}  // namespace syncline::sim
