// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "families/device_family.h"
#include "sim/devices/object_value.h"
#include "support/types.h"

namespace syncline::sim {

/// Values of sub-index 1 (ETG.1020, 0x1C32 and 0x1C33).
enum class SyncType : std::uint16_t { kFreeRun = 0, kOwnSyncManager = 1, kSync0 = 2, kSync1 = 3, kSyncManager2 = 0x22 };

/// What a device's firmware can do, and how long it takes. Times in ns.
struct SyncHabits {
  /// Bits of sub-index 4: free run, SyncManager event, SYNC0, SYNC1, shift by a local timer, measures its times.
  enum Supported : std::uint16_t {
    kFreeRun = 0x0001,
    kSyncManager = 0x0002,
    kSync0 = 0x0004,
    kSync1 = 0x0008,
    kLocalShift = 0x0010,
    kMeasures = 0x4000,
  };
  /// What the table of device families says of a family with known counters, times and types.
  SyncHabits(const families::Family& family, std::uint16_t supported_bits, std::uint32_t minimum);

  std::uint16_t supported;
  std::uint32_t minimum_cycle;
  std::uint32_t calc_and_copy, delay;  // worst case; from the trigger to the output or to latching
  families::SyncCounters counters;
  families::SyncTypes types;
  bool cycle_writable = false;  // the master tells its cycle in sub-index 2
  std::string_view delay_name = "Maximum delay time";
  std::string_view missed_name = "SM event missed counter", exceeded_name = "Cycle exceeded counter",
                   too_short_name = "Shift too short counter";
};

/// Synchronisation parameters of a SyncManager in the object dictionary of a simulated device, 0x1C32 (outputs) or
/// 0x1C33 (inputs). The counters count what the device reports here; the local times vary from cycle to cycle
/// below their worst case, and command 1 in sub-index 8 records the largest of each. What the master may write, the
/// types and the places of the counters are those of the device family.
class SyncObject {
 public:
  static constexpr std::uint16_t kOutputs = 0x1C32, kInputs = 0x1C33;

  SyncObject(ObjectDictionary& dictionary, std::uint16_t index, const SyncHabits& habits);
  SyncObject(const SyncObject&) = delete;
  SyncObject& operator=(const SyncObject&) = delete;

  [[nodiscard]] SyncType type() const { return static_cast<SyncType>(type_.get()); }
  void set_type(SyncType type) { type_.set(static_cast<std::uint16_t>(type)); }
  /// The master has written the type since power-on.
  [[nodiscard]] bool type_told() const { return type_told_; }
  [[nodiscard]] std::uint32_t cycle() const { return cycle_.get(); }
  void set_cycle(std::uint32_t ns) { cycle_.set(ns); }
  /// The master has written another cycle time since INIT than that of the SYNC signals.
  [[nodiscard]] bool contradicts(std::uint32_t sync0_ns) const { return told_cycle_ != 0 && told_cycle_ != sync0_ns; }
  void forget_told_cycle() { told_cycle_ = 0; }
  /// Of the SYNC0 signal; 0: none.
  void set_sync0_cycle(std::uint32_t ns) { sync0_cycle_.set(ns); }
  [[nodiscard]] std::uint32_t shift() const { return shift_.get(); }

  /// How long this cycle's calculation and copying takes.
  struct LocalTimes {
    Nanoseconds calc_and_copy = 0, delay = 0;
  };
  /// `extra`: what an overloaded application adds.
  LocalTimes next_cycle(Nanoseconds extra);
  /// The last of so many cycles, at least one.
  LocalTimes pass_cycles(std::uint64_t count, Nanoseconds extra);
  /// None takes longer.
  [[nodiscard]] LocalTimes longest(Nanoseconds extra) const {
    return {habits_.calc_and_copy + extra, static_cast<Nanoseconds>(habits_.delay)};
  }

  void count_missed() { count(missed_); }
  void count_exceeded() { count(exceeded_); }
  void count_shift_too_short() { count(shift_too_short_); }
  void clear_counters();
  /// Of the last cycle; not latched.
  void set_sync_error(bool error) { sync_error_.set(error ? 1 : 0); }

 private:
  void add_entries(const char* name);
  [[nodiscard]] bool supports(std::uint16_t type) const;
  static constexpr std::uint32_t kNoiseFactor = 1'664'525, kNoiseSum = 1'013'904'223;
  static void count(std::optional<ObjectValue<std::uint16_t>>& counter) {
    if (counter) counter->set(static_cast<std::uint16_t>(counter->get() + 1));
  }
  std::uint32_t start_measurement(std::span<const std::uint8_t> data);
  [[nodiscard]] Nanoseconds vary(std::uint32_t worst);
  void next_noise() { noise_ = noise_ * kNoiseFactor + kNoiseSum; }
  /// The same so many times.
  void skip_noise(std::uint64_t times);

  ObjectDictionary& dictionary_;
  std::uint16_t index_;
  SyncHabits habits_;
  ObjectValue<std::uint16_t> type_;
  std::optional<ObjectValue<std::uint16_t>> missed_, exceeded_, shift_too_short_;  // empty: the family has none
  ObjectValue<std::uint32_t> cycle_, shift_, minimum_cycle_, calc_and_copy_, delay_, sync0_cycle_;
  ObjectValue<std::uint8_t> sync_error_;
  std::uint32_t noise_ = 1;
  std::uint32_t told_cycle_ = 0;  // 0: none
  bool measuring_ = false;
  bool type_told_ = false;
};

}  // namespace syncline::sim
