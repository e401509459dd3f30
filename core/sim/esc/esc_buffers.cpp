// SPDX-License-Identifier: Apache-2.0
// What FMMUs map, and what SyncManagers allow.
#include <algorithm>

#include "protocol/registers.h"
#include "sim/esc/esc.h"
#include "sim/esc/esc_events.h"
#include "sim/registers/esc_ranges.h"
#include "sim/registers/short_copy.h"

namespace syncline::sim {

using namespace esc_events;

namespace {

bool get_bit(std::span<const std::uint8_t> bytes, std::size_t bit) { return ((bytes[bit / 8] >> (bit % 8)) & 1) != 0; }
void put_bit(std::span<std::uint8_t> bytes, std::size_t bit, bool value) {
  const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
  bytes[bit / 8] = static_cast<std::uint8_t>(value ? bytes[bit / 8] | mask : bytes[bit / 8] & ~mask);
}

}  // namespace

void Esc::reload_maps() {
  maps_stale_ = false;
  settings_changed();
  read_mappings_.clear();
  write_mappings_.clear();
  for (unsigned i = 0; i < options_.fmmu_count; ++i) {
    const auto fmmu = Fmmu::decode(memory_.at(reg::fmmu(i), Fmmu::kSize).first<Fmmu::kSize>());
    if (!fmmu.active || fmmu.length == 0) continue;
    if (fmmu.write) write_mappings_.push_back({fmmu});
    if (fmmu.read) read_mappings_.push_back({fmmu});
  }
  buffers_begin_ = EscMemory::kSize;
  active_managers_.clear();
  mailboxes_ = 0;
  for (unsigned i = 0; i < sync_managers_.size(); ++i) {
    const auto& sm = sync_managers_[i] = sync_manager(i);
    if (sm.is_mailbox()) mailboxes_ |= 1U << i;
    if (!sm.enabled() || sm.length == 0) continue;
    active_managers_.push_back(static_cast<std::uint8_t>(i));
    buffers_begin_ = std::min<std::uint32_t>(buffers_begin_, sm.start);
  }
  for (auto* mappings : {&write_mappings_, &read_mappings_}) {
    for (auto& mapping : *mappings) mapping.whole_buffer = find_whole_buffer(mapping.fmmu);
  }
}

/// Whether the FMMU maps a buffered SyncManager as a whole, and nothing else: then only the write protection can forbid
/// an access to all of it.
std::optional<unsigned> Esc::find_whole_buffer(const Fmmu& fmmu) const {
  const bool bytes =
      fmmu.logical_start_bit == 0 && fmmu.physical_start_bit == 0 && fmmu.bit_length() == 8U * fmmu.length;
  if (!bytes || fmmu.physical_start + fmmu.length > EscMemory::kSize) return std::nullopt;
  std::optional<unsigned> found;
  for (const unsigned i : active_managers_) {
    const auto& sm = sync_managers_[i];
    if (!overlaps(fmmu.physical_start, fmmu.length, sm.start, sm.length)) continue;
    const bool same = sm.start == fmmu.physical_start && sm.length == fmmu.length;
    if (found || !same || sm.is_mailbox() || fmmu.read == fmmu.write || sm.ecat_writes() != fmmu.write)
      return std::nullopt;
    found = i;
  }
  return buffer_allows(fmmu.physical_start, fmmu.length, fmmu.write) ? found : std::nullopt;
}

bool Esc::managers_allow(std::uint32_t address, std::size_t length, bool write) const {
  for (const unsigned i : active_managers_) {
    const auto& sm = sync_managers_[i];
    if ((sm.pdi_control & kPdiDeactivated) != 0 && overlaps(address, length, sm.start, sm.length)) return false;
    // Buffers 2 and 3 of a buffered SyncManager belong to the ESC alone.
    if (!sm.is_mailbox() && sm.start >= EscMemory::kRegisterEnd &&
        overlaps(address, length, sm.start + sm.length, 2U * sm.length)) {
      return false;
    }
    if (!overlaps(address, length, sm.start, sm.length)) continue;
    if (sm.ecat_writes() != write) return !write && !sm.is_mailbox();
    const bool full = (sm.status & SyncManager::kStatusMailboxFull) != 0;
    if (sm.is_mailbox() && full == write) return false;                    // full: no write; empty: no read
    if (address > sm.start && (sm_begun_ & (1U << i)) == 0) return false;  // begins at the first byte
  }
  return true;
}

void Esc::note_buffer_access(std::uint32_t address, std::size_t length, bool write) {
  if (address + length <= buffers_begin_) return;
  for (const unsigned i : active_managers_) {
    const auto& sm = sync_managers_[i];
    if (sm.ecat_writes() != write) continue;
    const std::uint32_t last = sm.start + sm.length - 1U;
    if (address <= sm.start && sm.start < address + length) sm_begun_ |= 1U << i;
    if (address <= last && last < address + length) {
      end_transfer(i, write);
    }
  }
}

[[gnu::noinline]] void Esc::open_buffer(std::uint32_t address, std::size_t length) {
  for (unsigned i = 0; any_pending_ && i < sync_managers_.size(); ++i) {
    if (pending_[i].empty()) continue;
    const auto start = sync_managers_[i].start;
    if (address <= start && start < address + length) show_pending(i);
  }
}

void Esc::end_transfer(unsigned number, bool write) {
  (write ? sm_written_ : sm_read_) |= 1U << number;
  if (!write) buffers_.read(number);
  sm_begun_ &= ~(1U << number);
}

void Esc::copy_mapped(std::span<std::uint8_t> datagram, std::uint64_t datagram_bit, std::uint64_t memory_bit,
                      std::uint64_t bits, bool writing) {
  auto memory = memory_.at(0, EscMemory::kSize);
  if (datagram_bit % 8 == 0 && memory_bit % 8 == 0 && bits % 8 == 0) {
    const auto in_frame = datagram.subspan(datagram_bit / 8, bits / 8);
    const auto in_memory = memory.subspan(memory_bit / 8, bits / 8);
    writing ? short_copy(in_frame, in_memory) : short_copy(in_memory, in_frame);
    return;
  }
  for (std::uint64_t bit = 0; bit < bits; ++bit) {
    if (writing) {
      put_bit(memory, memory_bit + bit, get_bit(datagram, datagram_bit + bit));
    } else {
      put_bit(datagram, datagram_bit + bit, get_bit(memory, memory_bit + bit));
    }
  }
}

bool Esc::map_datagram(const PassingDatagram& datagram, std::span<const Mapping> mappings, bool writing) {
  bool any = false;
  const std::uint64_t start = datagram.address;
  const std::uint64_t end = start + datagram.data.size();
  for (const auto& [fmmu, whole_buffer] : mappings) {
    if (whole_buffer && fmmu.logical_start >= start && fmmu.logical_start + std::uint64_t{fmmu.length} <= end) {
      if (writing && !protection_.allows(fmmu.physical_start, fmmu.length)) continue;
      if (!writing) open_buffer(fmmu.physical_start, fmmu.length);
      const auto in_frame = datagram.data.subspan(fmmu.logical_start - start, fmmu.length);
      const auto in_memory = memory_.at(fmmu.physical_start, fmmu.length);
      writing ? short_copy(in_frame, in_memory) : short_copy(in_memory, in_frame);
      end_transfer(*whole_buffer, writing);
      any = true;
    } else if (map_part(datagram, fmmu, writing)) {
      any = true;
    }
  }
  return any;
}

bool Esc::map_part(const PassingDatagram& datagram, const Fmmu& fmmu, bool writing) {
  const std::uint64_t start = 8ULL * datagram.address;
  const std::uint64_t first_bit = 8ULL * fmmu.logical_start + fmmu.logical_start_bit;
  const std::uint64_t from = std::max(first_bit, start);
  const std::uint64_t to = std::min(first_bit + fmmu.bit_length(), start + 8 * datagram.data.size());
  if (from >= to) return false;
  const std::uint64_t physical = 8ULL * fmmu.physical_start + fmmu.physical_start_bit + (from - first_bit);
  const auto address = static_cast<std::uint32_t>(physical / 8);
  const auto length = static_cast<std::size_t>((physical + (to - from) + 7) / 8 - physical / 8);
  if (address + length > EscMemory::kSize || !buffer_allows(address, length, writing)) return false;
  if (writing && !protection_.allows(address, length)) return false;
  if (!writing) open_buffer(address, length);
  if (overlaps(address, length, DcUnit::kShownBegin, DcUnit::kShownSize)) {
    dc_.start_of_frame(frame_time_);
    dc_.refresh_registers();
  }
  copy_mapped(datagram.data, from - start, physical, to - from, writing);
  note_buffer_access(address, length, writing);
  return true;
}

}  // namespace syncline::sim
