// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/fmmu_unit.h"

#include <algorithm>

#include "protocol/registers.h"
#include "sim/dc/dc_unit.h"
#include "sim/esc/passing_frame.h"
#include "sim/esc/sync_managers.h"
#include "sim/registers/esc_memory.h"
#include "sim/registers/esc_ranges.h"
#include "sim/registers/short_copy.h"
#include "sim/registers/write_protection.h"

namespace syncline::sim {
namespace {

bool get_bit(std::span<const std::uint8_t> bytes, std::size_t bit) { return ((bytes[bit / 8] >> (bit % 8)) & 1) != 0; }
void put_bit(std::span<std::uint8_t> bytes, std::size_t bit, bool value) {
  const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
  bytes[bit / 8] = static_cast<std::uint8_t>(value ? bytes[bit / 8] | mask : bytes[bit / 8] & ~mask);
}

}  // namespace

void FmmuUnit::implement_registers() {
  memory_.implement(reg::kFmmu, static_cast<std::uint16_t>(Fmmu::kSize * count_), EscMemory::kReadWrite);
}

void FmmuUnit::reload() {
  reading_.clear();
  writing_.clear();
  for (unsigned i = 0; i < count_; ++i) {
    const auto fmmu = Fmmu::decode(memory_.at(reg::fmmu(i), Fmmu::kSize).first<Fmmu::kSize>());
    if (!fmmu.active || fmmu.length == 0) continue;
    const Mapping mapping{fmmu, find_whole_buffer(fmmu)};
    if (fmmu.write) writing_.push_back(mapping);
    if (fmmu.read) reading_.push_back(mapping);
  }
}

/// Whether the FMMU maps a buffered SyncManager as a whole, and nothing else: then only the write protection can forbid
/// an access to all of it.
std::optional<unsigned> FmmuUnit::find_whole_buffer(const Fmmu& fmmu) const {
  const bool bytes =
      fmmu.logical_start_bit == 0 && fmmu.physical_start_bit == 0 && fmmu.bit_length() == 8U * fmmu.length;
  if (!bytes || fmmu.physical_start + fmmu.length > EscMemory::kSize) return std::nullopt;
  std::optional<unsigned> found;
  for (const unsigned i : managers_.active()) {
    const auto& sm = managers_.decoded(i);
    if (!overlaps(fmmu.physical_start, fmmu.length, sm.start, sm.length)) continue;
    const bool same = sm.start == fmmu.physical_start && sm.length == fmmu.length;
    if (found || !same || sm.is_mailbox() || fmmu.read == fmmu.write || sm.ecat_writes() != fmmu.write)
      return std::nullopt;
    found = i;
  }
  return managers_.allow(fmmu.physical_start, fmmu.length, fmmu.write) ? found : std::nullopt;
}

bool FmmuUnit::map(const PassingDatagram& datagram, std::span<const Mapping> mappings, bool writing,
                   Nanoseconds frame_time) {
  bool any = false;
  const std::uint64_t start = datagram.address;
  const std::uint64_t end = start + datagram.data.size();
  for (const auto& [fmmu, whole_buffer] : mappings) {
    if (whole_buffer && fmmu.logical_start >= start && fmmu.logical_start + std::uint64_t{fmmu.length} <= end) {
      if (writing && !protection_.allows(fmmu.physical_start, fmmu.length)) continue;
      if (!writing) managers_.open(fmmu.physical_start, fmmu.length);
      const auto in_frame = datagram.data.subspan(fmmu.logical_start - start, fmmu.length);
      const auto in_memory = memory_.at(fmmu.physical_start, fmmu.length);
      writing ? short_copy(in_frame, in_memory) : short_copy(in_memory, in_frame);
      managers_.end_transfer(*whole_buffer, writing);
      any = true;
    } else if (map_part(datagram, fmmu, writing, frame_time)) {
      any = true;
    }
  }
  return any;
}

bool FmmuUnit::map_part(const PassingDatagram& datagram, const Fmmu& fmmu, bool writing, Nanoseconds frame_time) {
  const std::uint64_t start = 8ULL * datagram.address;
  const std::uint64_t first_bit = 8ULL * fmmu.logical_start + fmmu.logical_start_bit;
  const std::uint64_t from = std::max(first_bit, start);
  const std::uint64_t to = std::min(first_bit + fmmu.bit_length(), start + 8 * datagram.data.size());
  if (from >= to) return false;
  const std::uint64_t physical = 8ULL * fmmu.physical_start + fmmu.physical_start_bit + (from - first_bit);
  const auto address = static_cast<std::uint32_t>(physical / 8);
  const auto length = static_cast<std::size_t>((physical + (to - from) + 7) / 8 - physical / 8);
  if (address + length > EscMemory::kSize || !managers_.allow(address, length, writing)) return false;
  if (writing && !protection_.allows(address, length)) return false;
  if (!writing) managers_.open(address, length);
  if (overlaps(address, length, DcUnit::kShownBegin, DcUnit::kShownSize)) {
    clock_.start_of_frame(frame_time);
    clock_.refresh_registers();
  }
  copy(datagram.data, from - start, physical, to - from, writing);
  managers_.note_access(address, length, writing);
  return true;
}

void FmmuUnit::copy(std::span<std::uint8_t> datagram, std::uint64_t datagram_bit, std::uint64_t memory_bit,
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

}  // namespace syncline::sim
