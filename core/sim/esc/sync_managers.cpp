// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/sync_managers.h"

#include <algorithm>
#include <utility>

#include "sim/esc/esc_events.h"
#include "sim/registers/esc_ranges.h"
#include "sim/registers/short_copy.h"

namespace syncline::sim {

using namespace esc_events;

void SyncManagers::implement_registers() {
  memory_.implement(reg::kSyncManager, static_cast<std::uint16_t>(SyncManager::kSize * count()), EscMemory::kReadWrite);
  for (unsigned i = 0; i < count(); ++i) {  // status, and what belongs to the PDI (ESC data sheet II, 2.31)
    memory_.implement(static_cast<std::uint16_t>(reg::sync_manager(i) + 5), 1, EscMemory::kRead);
    memory_.implement(static_cast<std::uint16_t>(reg::sync_manager(i) + 7), 1, EscMemory::kRead);
  }
}

void SyncManagers::reload() {
  stale_ = false;
  begin_ = EscMemory::kSize;
  active_.clear();
  mailboxes_ = 0;
  for (unsigned i = 0; i < managers_.size(); ++i) {
    const auto& sm = managers_[i] = in_registers(i);
    if (sm.is_mailbox()) mailboxes_ |= 1U << i;
    if (!sm.enabled() || sm.length == 0) continue;
    active_.push_back(static_cast<std::uint8_t>(i));
    begin_ = std::min<std::uint32_t>(begin_, sm.start);
  }
}

void SyncManagers::set_up_anew() {
  begun_ = 0;
  for (auto& bytes : pending_) bytes.clear();
  any_pending_ = false;
}

SyncManager SyncManagers::in_registers(unsigned number) const {
  return SyncManager::decode(
      std::as_const(memory_).at(reg::sync_manager(number), SyncManager::kSize).first<SyncManager::kSize>());
}

bool SyncManagers::locks_register(std::uint32_t address) const {
  if (address < reg::kSyncManager || address >= reg::kSyncManager + reg::kSyncManagersSize) return false;
  const auto place = (address - reg::kSyncManager) % SyncManager::kSize;
  return place < SyncManager::kPlaceOfStatus &&
         in_registers((address - reg::kSyncManager) / SyncManager::kSize).enabled();
}

std::span<const std::uint8_t> SyncManagers::area(unsigned number) const {
  if (!stale_ && number < managers_.size()) {
    const auto& sm = managers_[number];
    return memory_.at(sm.start, std::min<std::size_t>(sm.length, EscMemory::kSize - sm.start));
  }
  const auto start = memory_.u16(reg::sync_manager(number));
  const auto length = memory_.u16(static_cast<std::uint16_t>(reg::sync_manager(number) + 2));
  return memory_.at(start, std::min<std::size_t>(length, EscMemory::kSize - start));
}

std::span<std::uint8_t> SyncManagers::area(unsigned number) {
  const auto found = std::as_const(*this).area(number);
  return memory_.at(static_cast<std::uint32_t>(found.data() - memory_.at(0, 0).data()), found.size());
}

bool SyncManagers::each_allows(std::uint32_t address, std::size_t length, bool write) const {
  for (const unsigned i : active_) {
    const auto& sm = managers_[i];
    if ((sm.pdi_control & kPdiDeactivated) != 0 && overlaps(address, length, sm.start, sm.length)) return false;
    // Buffers 2 and 3 of a buffered SyncManager belong to the ESC alone.
    if (!sm.is_mailbox() && sm.start >= EscMemory::kRegisterEnd &&
        overlaps(address, length, sm.start + sm.length, 2U * sm.length)) {
      return false;
    }
    if (!overlaps(address, length, sm.start, sm.length)) continue;
    if (sm.ecat_writes() != write) return !write && !sm.is_mailbox();
    const bool full = (sm.status & SyncManager::kStatusMailboxFull) != 0;
    if (sm.is_mailbox() && full == write) return false;                 // full: no write; empty: no read
    if (address > sm.start && (begun_ & (1U << i)) == 0) return false;  // begins at the first byte
  }
  return true;
}

void SyncManagers::note_access(std::uint32_t address, std::size_t length, bool write) {
  if (address + length <= begin_) return;
  for (const unsigned i : active_) {
    const auto& sm = managers_[i];
    if (sm.ecat_writes() != write) continue;
    const std::uint32_t last = sm.start + sm.length - 1U;
    if (address <= sm.start && sm.start < address + length) begun_ |= 1U << i;
    if (address <= last && last < address + length) end_transfer(i, write);
  }
}

void SyncManagers::open(std::uint32_t address, std::size_t length) {
  if (any_pending_) open_pending(address, length);
}

void SyncManagers::open_pending(std::uint32_t address, std::size_t length) {
  for (unsigned i = 0; i < managers_.size(); ++i) {
    if (pending_[i].empty()) continue;
    const auto start = managers_[i].start;
    if (address <= start && start < address + length) show_pending(i);
  }
}

bool SyncManagers::put(unsigned number, std::span<const std::uint8_t> bytes) {
  const auto shown = area(number);
  bytes = bytes.first(std::min(bytes.size(), shown.size()));
  if ((begun_ & (1U << number)) != 0) {
    pending_[number].assign(bytes.begin(), bytes.end());
    any_pending_ = true;
    return false;
  }
  if (any_pending_) pending_[number].clear();
  short_copy(bytes, shown);
  return true;
}

void SyncManagers::show_pending(unsigned number) {
  const auto& bytes = pending_[number];
  if (bytes.empty()) return;
  const auto shown = area(number);
  std::copy_n(bytes.begin(), std::min(bytes.size(), shown.size()), shown.begin());
  pending_[number].clear();
}

void SyncManagers::set_mailbox_full(unsigned number, bool full) {
  const auto address = static_cast<std::uint16_t>(reg::sync_manager(number) + SyncManager::kPlaceOfStatus);
  const auto status = memory_.u8(address);
  memory_.set<std::uint8_t>(address, static_cast<std::uint8_t>(full ? status | SyncManager::kStatusMailboxFull
                                                                    : status & ~SyncManager::kStatusMailboxFull));
  if (!stale_ && number < managers_.size()) managers_[number].status = memory_.u8(address);  // which no plan depends on
}

bool SyncManagers::repeat_requested(unsigned number) const {
  const auto base = reg::sync_manager(number);
  return ((memory_.u8(static_cast<std::uint16_t>(base + 6)) ^ memory_.u8(static_cast<std::uint16_t>(base + 7))) &
          kRepeatBit) != 0;
}

void SyncManagers::acknowledge_repeat(unsigned number) {
  const auto address = static_cast<std::uint16_t>(reg::sync_manager(number) + 7);
  memory_.set<std::uint8_t>(address, static_cast<std::uint8_t>(memory_.u8(address) ^ kRepeatBit));
  stale_ = true;
}

void SyncManagers::deactivate(unsigned number, bool deactivated) {
  const auto address = static_cast<std::uint16_t>(reg::sync_manager(number) + 7);
  const auto control = memory_.u8(address);
  memory_.set<std::uint8_t>(
      address, static_cast<std::uint8_t>(deactivated ? control | kPdiDeactivated : control & ~kPdiDeactivated));
  stale_ = true;
}

}  // namespace syncline::sim
