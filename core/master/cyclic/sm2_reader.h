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

/// Reads what slaves count in 0x1C32 and 0x1C33, one object of one slave after the other, through the mailboxes of the
/// running bus. Of slaves with SYNC signals missed SM2 events in every second turn; cycles exceeded, shift too short
/// and sync error in the others; and once the limit that the missed events obey (0x10F1:02) and the calc-and-copy time
/// (0x1C32:06). Of those that begin their cycles with the process data, or by themselves, the cycles exceeded alone:
/// the rest needs a SYNC signal (ETG.1020, table of 0x1C32). What a slave does not have is asked for once. Allocates
/// nothing.
///
/// A slave whose cycles begin with the process data does not finish one either when the next frame comes too soon,
/// behind one that was late or held up: as many of the exceeded cycles as there were such frames are theirs, and no
/// firmware's. Where a clock leads it says how far apart they came.
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

  /// The cycle's frames were handed to the link, and passed the reference clock when it showed this, ns, where that is
  /// known; `late`: one of before has come back meanwhile, behind its cycle. Once a cycle.
  void sent(Nanoseconds time, std::optional<Nanoseconds> reference_time, bool late);
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
    std::array<bool, 4> rising{};                 // so at the newest reading
    std::array<std::uint64_t, 4> close_before{};  // frames that came too soon, when that was asked for
  };
  static constexpr CounterTotal kWord{16, CounterTotal::End::kWraps};
  static constexpr std::uint16_t bit(Item item) {
    return static_cast<std::uint16_t>(1U << static_cast<unsigned>(item));
  }

  static constexpr std::uint16_t exceeded() { return bit(Item::kOutputsExceeded) | bit(Item::kInputsExceeded); }

  void add(std::size_t position, bool sync);
  /// It is known which of the two counts what.
  static void tell_apart(Counter& counter);
  [[nodiscard]] bool has_others() const { return counters_.size() > with_sync_; }
  /// Whose turn is next.
  [[nodiscard]] std::size_t next();
  static void choose(Counter& counter);
  [[nodiscard]] static coe::ObjectAddress object(const Counter& counter);
  void take_value(Counter& counter, std::uint32_t value, Nanoseconds now, CycleSample& sample);
  /// Of so many exceeded cycles those that frames account for which came too soon.
  [[nodiscard]] std::uint32_t by_frames(Counter& counter, std::size_t which, std::uint32_t more) const;
  void tell_exceeded(Counter& counter, std::size_t which, std::uint32_t more, Nanoseconds now);
  void take_missed(const Counter& counter, std::uint32_t value, Nanoseconds now, CycleSample& sample);

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  EventTeller& teller_;
  CyclicMailbox& mailbox_;
  SyncEventWatch& events_;
  std::vector<Counter> counters_;  // those with SYNC signals first
  std::size_t with_sync_ = 0;
  std::size_t current_ = 0, turn_ = 0, other_ = 0;
  std::uint64_t close_ = 0, close_when_asked_ = 0;  // frames that came too soon
  Nanoseconds last_sent_ = 0;
  std::optional<Nanoseconds> last_passed_;
  Nanoseconds next_start_ = 0;
};

}  // namespace syncline
