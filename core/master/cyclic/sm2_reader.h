// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "master/cyclic/cyclic_mailbox.h"
#include "support/counter_total.h"

namespace syncline {

struct CycleSample;
class EventTeller;
struct NetworkConfig;
struct Snapshot;
class SyncEventWatch;

/// Reads what slaves with SYNC signals count in 0x1C32 and 0x1C33, one object of one slave after the other, through the
/// mailboxes of the running bus: missed SM2 events in every second turn; cycles exceeded, shift too short and sync
/// error in the others; and once the limit that the missed events obey (0x10F1:02) and the calc-and-copy time
/// (0x1C32:06). What a slave does not have is asked for once. Allocates nothing.
class Sm2Reader {
 public:
  Sm2Reader(const NetworkConfig& config, Snapshot& snapshot, EventTeller& teller, CyclicMailbox& mailbox,
            SyncEventWatch& events);
  Sm2Reader(const Sm2Reader&) = delete;
  Sm2Reader& operator=(const Sm2Reader&) = delete;

  /// Slaves whose counter is read.
  [[nodiscard]] std::vector<std::size_t> slaves() const;
  /// The sub-index that the object's names gave; see sm2_counter_profile.h.
  void set_sub_index(std::size_t slave, std::uint8_t sub_index);

  /// Begins an upload when its time has come and the mailbox is free.
  void begin(Nanoseconds now);
  void take(const CyclicMailbox::Answer& answer, Nanoseconds now, CycleSample& sample);

 private:
  enum class Item : std::uint8_t {
    kLimit,
    kCalcAndCopy,  // once
    kMissed,       // every second turn
    kOther,
    kOutputsExceeded,
    kOutputsShift,
    kSyncError,
    kInputsExceeded,
    kInputsShift,  // in turn
  };
  static constexpr std::uint8_t kItems = 9;
  struct Counter {
    std::uint16_t slave = 0;
    std::uint8_t missed = 0, exceeded = 0;  // sub-indices
    std::uint16_t has = 0;                  // items that the slave may have, a bit each
    Item turn = Item::kMissed, rare = Item::kOther;
    std::array<CounterTotal, 4> totals{kWord, kWord, kWord, kWord};
    std::array<bool, 4> rising{};  // so at the newest reading
  };
  static constexpr CounterTotal kWord{16, CounterTotal::End::kWraps};
  static constexpr std::uint16_t bit(Item item) {
    return static_cast<std::uint16_t>(1U << static_cast<unsigned>(item));
  }

  static void choose(Counter& counter);
  [[nodiscard]] static coe::ObjectAddress object(const Counter& counter);
  void take_value(Counter& counter, std::uint32_t value, Nanoseconds now, CycleSample& sample);
  void tell_exceeded(Counter& counter, std::size_t which, std::uint32_t more, Nanoseconds now);
  void take_missed(const Counter& counter, std::uint32_t value, Nanoseconds now, CycleSample& sample);

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  EventTeller& teller_;
  CyclicMailbox& mailbox_;
  SyncEventWatch& events_;
  std::vector<Counter> counters_;
  std::size_t current_ = 0;
  Nanoseconds next_start_ = 0;
};

}  // namespace syncline
