// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "protocol/fmmu.h"
#include "support/types.h"

namespace syncline::sim {

class DcUnit;
class EscMemory;
class SyncManagers;
class WriteProtection;
struct PassingDatagram;

/// FMMUs of an ESC (registers 0x0600 + 16 n; ESC data sheet I, chapter 7): which bits of a logical datagram are which
/// of the ESC's memory, as far as SyncManagers and write protection let the master at it.
class FmmuUnit {
 public:
  /// One that is active; with the buffered SyncManager that it maps as a whole, where nothing but the write protection
  /// can forbid such an access: the usual case, which is then decided once and not in each frame.
  struct Mapping {
    Fmmu fmmu;
    std::optional<unsigned> whole_buffer{};
  };

  FmmuUnit(EscMemory& memory, SyncManagers& managers, WriteProtection& protection, DcUnit& clock, unsigned count)
      : memory_(memory), managers_(managers), protection_(protection), clock_(clock), count_(count) {}

  void implement_registers();
  /// What the registers say, behind SyncManagers::reload().
  void reload();

  /// What they map of a datagram of the frame that began to pass at `frame_time`. False: nothing.
  [[nodiscard]] bool write(const PassingDatagram& datagram, Nanoseconds frame_time) {
    return map(datagram, writing_, true, frame_time);
  }
  [[nodiscard]] bool read(const PassingDatagram& datagram, Nanoseconds frame_time) {
    return map(datagram, reading_, false, frame_time);
  }
  /// In the order of their numbers.
  [[nodiscard]] std::span<const Mapping> writing() const { return writing_; }
  [[nodiscard]] std::span<const Mapping> reading() const { return reading_; }

 private:
  [[nodiscard]] bool map(const PassingDatagram& datagram, std::span<const Mapping> mappings, bool writing,
                         Nanoseconds frame_time);
  /// What one maps, byte by byte or bit by bit.
  [[nodiscard]] bool map_part(const PassingDatagram& datagram, const Fmmu& fmmu, bool writing, Nanoseconds frame_time);
  /// Copies `bits` between a datagram and the memory, whole bytes at once where the mapping is aligned.
  void copy(std::span<std::uint8_t> datagram, std::uint64_t datagram_bit, std::uint64_t memory_bit, std::uint64_t bits,
            bool writing);
  [[nodiscard]] std::optional<unsigned> find_whole_buffer(const Fmmu& fmmu) const;

  EscMemory& memory_;
  SyncManagers& managers_;
  WriteProtection& protection_;
  DcUnit& clock_;
  unsigned count_;
  std::vector<Mapping> writing_, reading_;
};

}  // namespace syncline::sim
