// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "protocol/registers.h"
#include "protocol/sync_manager.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// Which of the three buffers of each buffered SyncManager the PDI has written last, and which one the master reads
/// (ESC data sheet I, 7.1): it never writes into the one that is being read. Shown in 0x0805 + 8 n, bits 5:4.
class ThreeBuffers {
 public:
  ThreeBuffers(EscMemory& memory, unsigned sync_managers) : memory_(memory), buffers_(sync_managers) {}

  [[nodiscard]] bool has(unsigned number) const { return number < buffers_.size(); }
  /// The PDI writes so many times, and the master does not read meanwhile.
  void write(unsigned number, std::uint64_t times = 1) {
    if (times == 0) return;
    take_turns();
    auto& buffers = buffers_[number];
    // The one that is read stays, so that behind the first time two of them take turns.
    buffers.written = next(buffers);
    if (times % 2 == 0) buffers.written = next(buffers);
    unshown_ |= 1U << number;
  }
  /// The bit is one of those that show() brings up to date.
  [[nodiscard]] static bool shows(std::uint32_t address, unsigned bit) {
    return address >= reg::kSyncManager && address < reg::kSyncManager + reg::kSyncManagersSize &&
           address % SyncManager::kSize == kStatus && (SyncManager::kStatusBuffer >> bit & 1U) != 0;
  }
  /// Brings the status registers up to date: before somebody looks at them or writes them.
  void show() {
    take_turns();
    for (; unshown_ != 0; unshown_ &= unshown_ - 1) {
      const auto number = static_cast<unsigned>(std::countr_zero(unshown_));
      const auto address = static_cast<std::uint16_t>(reg::sync_manager(number) + kStatus);
      const auto others = memory_.u8(address) & ~SyncManager::kStatusBuffer;
      memory_.set<std::uint8_t>(address, static_cast<std::uint8_t>(others | buffers_[number].written << kShift));
    }
  }
  /// The master reads the one that was written last.
  void read(unsigned number) {
    take_turns();
    buffers_[number].read = buffers_[number].written;
  }
  /// What a cycle does to those of inputs (a bit each): the PDI writes once, then the master reads. That is counted.
  void write_and_read(std::uint32_t numbers) {
    if (numbers != turning_) {
      take_turns();
      turning_ = numbers;
    }
    ++turns_;
  }

 private:
  static constexpr std::uint16_t kStatus = SyncManager::kPlaceOfStatus;
  static constexpr unsigned kShift = 4;
  static constexpr std::uint8_t kNone = 3;
  struct Buffers {
    std::uint8_t written = kNone, read = kNone;  // 0 to 2
  };
  [[nodiscard]] static std::uint8_t next(const Buffers& buffers) {
    const auto taken = 1U << buffers.written | 1U << buffers.read;
    return static_cast<std::uint8_t>(std::countr_one(taken));  // the first that is free
  }

  /// Those that have been counted.
  void take_turns() {
    if (turns_ != 0) [[unlikely]]
      take_each_turn();
  }
  [[gnu::noinline]] void take_each_turn() {
    // From the third turn on two buffers change places.
    constexpr std::uint64_t kFirst = 4;
    for (auto left = turns_ > kFirst ? kFirst + turns_ % 2 : turns_; left > 0; --left) {
      for (auto numbers = turning_; numbers != 0; numbers &= numbers - 1) {
        auto& buffers = buffers_[static_cast<unsigned>(std::countr_zero(numbers))];
        buffers.read = buffers.written = next(buffers);
      }
    }
    unshown_ |= turning_;
    turns_ = 0;
  }

  EscMemory& memory_;
  std::vector<Buffers> buffers_;
  std::uint32_t unshown_ = 0;  // bit per SyncManager: its status is not up to date
  std::uint32_t turning_ = 0;  // bit per SyncManager, of the turns that are counted
  std::uint64_t turns_ = 0;
};

}  // namespace syncline::sim
