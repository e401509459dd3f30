// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sim/object_dictionary.h"
#include "support/types.h"

namespace syncline::sim {

/// Values of sub-index 1 (ETG.1020, 0x1C32 and 0x1C33).
enum class SyncType : std::uint16_t { kFreeRun = 0, kOwnSyncManager = 1, kSync0 = 2, kSync1 = 3, kSyncManager2 = 0x22 };

/// What a device's firmware can do, and how long it takes. Times in ns.
struct SyncHabits {
  /// Bits of sub-index 4: free run, SyncManager event, SYNC0, SYNC1, shift by a local timer, measures its times.
  enum Supported : std::uint16_t {
    kFreeRun = 0x0001, kSyncManager = 0x0002, kSync0 = 0x0004, kSync1 = 0x0008, kLocalShift = 0x0010, kMeasures = 0x4000,
  };
  std::uint16_t supported = kFreeRun | kSync0 | kMeasures;
  std::uint32_t minimum_cycle = 125'000;
  std::uint32_t calc_and_copy = 62'500;       // worst case
  std::uint32_t delay = 10'000;               // worst case, from the trigger to the output or to latching
  std::uint8_t missed_sub_index = 0x0B;       // 0x0C in the older object layout; the other one counts exceeded cycles
  std::uint8_t exceeded_sub_index = 0x0C;
};

/// Synchronisation parameters of a SyncManager in the object dictionary of a simulated device, 0x1C32 (outputs) or
/// 0x1C33 (inputs). The counters count what the device reports here; the local times vary from cycle to cycle
/// below their worst case, and command 1 in sub-index 8 records the largest of each.
class SyncObject {
 public:
  static constexpr std::uint16_t kOutputs = 0x1C32, kInputs = 0x1C33;

  SyncObject(ObjectDictionary& dictionary, std::uint16_t index, const SyncHabits& habits);
  SyncObject(const SyncObject&) = delete;
  SyncObject& operator=(const SyncObject&) = delete;

  [[nodiscard]] SyncType type();
  [[nodiscard]] bool supports(SyncType type) const;
  void set_type(SyncType type);
  [[nodiscard]] std::uint32_t cycle();
  void set_cycle(std::uint32_t ns);
  /// Of the SYNC0 signal; 0: none.
  void set_sync0_cycle(std::uint32_t ns);
  [[nodiscard]] std::uint32_t shift();

  /// How long this cycle's calculation and copying takes.
  struct LocalTimes {
    Nanoseconds calc_and_copy = 0, delay = 0;
  };
  /// `extra`: what an overloaded application adds.
  LocalTimes next_cycle(Nanoseconds extra);

  void count_missed() { count(habits_.missed_sub_index); }
  void count_exceeded() { count(habits_.exceeded_sub_index); }
  void count_shift_too_short();
  [[nodiscard]] std::uint16_t missed();
  void clear_counters();
  /// Of the last cycle; not latched.
  void set_sync_error(bool error);

 private:
  void add_entries(const char* name);
  void count(std::uint8_t sub_index);
  std::uint32_t start_measurement(std::span<const std::uint8_t> data);
  [[nodiscard]] Nanoseconds vary(std::uint32_t worst);

  ObjectDictionary& dictionary_;
  std::uint16_t index_;
  SyncHabits habits_;
  std::uint32_t noise_ = 1;
  bool measuring_ = false;
};

}  // namespace syncline::sim
