// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "protocol/registers.h"
#include "protocol/sync_manager.h"
#include "sim/esc/three_buffers.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// SyncManagers of an ESC (registers 0x0800 + 8 n; ESC data sheet I, chapter 8): whether the master may be let at their
/// memory now, when a transfer of his has begun and is complete, the state of mailboxes and buffers, and what the PDI
/// locks. They are decoded when their registers were written (reload()), not in each frame. Sets of them are a bit
/// each.
class SyncManagers {
 public:
  SyncManagers(EscMemory& memory, unsigned count)
      : memory_(memory), managers_(count), pending_(count), buffers_(memory, count) {}

  void implement_registers();

  // ---- settings ----
  /// Registers were written since reload(), theirs or those of FMMUs, which depend on them.
  [[nodiscard]] bool stale() const { return stale_; }
  void outdate() { stale_ = true; }
  void reload();
  /// The master has written to their registers: what was under way is over.
  void set_up_anew();
  [[nodiscard]] unsigned count() const { return static_cast<unsigned>(managers_.size()); }
  [[nodiscard]] bool has(unsigned number) const { return number < managers_.size(); }
  /// As the registers are now; as they were at reload(), with the status of now.
  [[nodiscard]] SyncManager in_registers(unsigned number) const;
  [[nodiscard]] const SyncManager& decoded(unsigned number) const { return managers_[number]; }
  /// By their numbers: those that are on and have a length.
  [[nodiscard]] std::span<const std::uint8_t> active() const { return active_; }
  /// On or not.
  [[nodiscard]] std::uint32_t mailboxes() const { return mailboxes_; }
  /// Where the first one's memory begins.
  [[nodiscard]] std::uint32_t begin() const { return begin_; }
  /// Where one is and which way it goes can be written only while it is disabled (ESC data sheet II, 2.31).
  [[nodiscard]] bool locks_register(std::uint32_t address) const;
  /// Its memory, cut where a master has set it up beyond the address space.
  [[nodiscard]] std::span<const std::uint8_t> area(unsigned number) const;
  [[nodiscard]] std::span<std::uint8_t> area(unsigned number);

  // ---- the master's side ----
  /// Whether they let the master at this memory now.
  [[nodiscard]] bool allow(std::uint32_t address, std::size_t length, bool write) const {
    return address + length <= begin_ || each_allows(address, length, write);  // registers, nearly always
  }
  /// The master has been let at it: which transfers begin and end by that.
  void note_access(std::uint32_t address, std::size_t length, bool write);
  /// The first byte of a buffer is read: the newest one is shown, whatever became of the transfer before.
  void open(std::uint32_t address, std::size_t length);
  void end_transfer(unsigned number, bool write) {
    (write ? written_ : read_) |= 1U << number;
    if (!write) buffers_.read(number);
    begun_ &= ~(1U << number);
  }
  /// Transfers of whole buffers, which begin and end in one frame, are no longer under way.
  void pass(std::uint32_t numbers) { begun_ &= ~numbers; }
  /// The frame was damaged: none of its transfers is one.
  void forget_transfers() { written_ = read_ = begun_ = 0; }

  // ---- transfers that are complete, until their end has been told ----
  [[nodiscard]] std::uint32_t written() const { return written_; }
  [[nodiscard]] std::uint32_t read() const { return read_; }
  void add_transfers(std::uint32_t written, std::uint32_t read) {
    written_ |= written;
    read_ |= read;
  }
  void set_transfers(std::uint32_t written, std::uint32_t read) {
    written_ = written;
    read_ = read;
  }

  // ---- the PDI's side ----
  /// Bytes that the master reads from a buffered one. False: a transfer under way still shows the buffer before.
  [[nodiscard]] bool put(unsigned number, std::span<const std::uint8_t> bytes);
  /// Some bytes have been put that are not shown yet, perhaps.
  [[nodiscard]] bool any_pending() const { return any_pending_; }
  void show_pending(unsigned number);
  void set_mailbox_full(unsigned number, bool full);
  /// Repeat request of the master against the PDI's acknowledgement (0x0806 bit 1, 0x0807 bit 1).
  [[nodiscard]] bool repeat_requested(unsigned number) const;
  void acknowledge_repeat(unsigned number);
  /// 0x0807 bit 0: the master is not let at its memory.
  void deactivate(unsigned number, bool deactivated);

  [[nodiscard]] ThreeBuffers& buffers() { return buffers_; }

 private:
  [[nodiscard]] bool each_allows(std::uint32_t address, std::size_t length, bool write) const;
  [[gnu::noinline]] void open_pending(std::uint32_t address, std::size_t length);

  EscMemory& memory_;
  std::vector<SyncManager> managers_;
  std::vector<std::uint8_t> active_;
  std::vector<std::vector<std::uint8_t>> pending_;  // of each, not yet shown; empty: nothing
  std::uint32_t mailboxes_ = 0;
  std::uint32_t written_ = 0, read_ = 0;
  std::uint32_t begin_ = 0;
  bool stale_ = true, any_pending_ = false;
  // Of every frame, and therefore last: an ESC has the plans of its frames behind this.
  ThreeBuffers buffers_;
  std::uint32_t begun_ = 0;  // a transfer has touched its first byte and not yet its last; lasts over frames
};

}  // namespace syncline::sim
