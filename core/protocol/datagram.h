// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/command.h"
#include "support/byte_order.h"

namespace syncline {

inline constexpr std::size_t kDatagramHeaderSize = 10;
inline constexpr std::size_t kWkcSize = 2;
/// What a datagram has around its data.
inline constexpr std::size_t kDatagramOverhead = kDatagramHeaderSize + kWkcSize;

/// Datagram header (ETG.1000.4, 5.4). `address` is ADP in the low and ADO in the high word for
/// device addressing, or the 32-bit logical address.
struct DatagramHeader {
  Command command = Command::kNop;
  std::uint8_t index = 0;
  std::uint32_t address = 0;
  std::uint16_t length = 0;  // data bytes, 0..1486
  bool circulating = false;
  bool more = false;      // set by FrameBuilder
  std::uint16_t irq = 0;  // ECAT event field, OR of the slaves

  [[nodiscard]] constexpr std::uint16_t adp() const { return static_cast<std::uint16_t>(address); }
  [[nodiscard]] constexpr std::uint16_t ado() const { return static_cast<std::uint16_t>(address >> 16); }
  bool operator==(const DatagramHeader&) const = default;

  [[nodiscard]] static DatagramHeader read(std::span<const std::uint8_t, kDatagramHeaderSize> bytes);
  void write(std::span<std::uint8_t, kDatagramHeaderSize> bytes) const;

  static constexpr std::size_t kLengthFieldOffset = 6, kIrqOffset = 8;
  static constexpr std::uint16_t kLengthMask = 0x07FF, kCirculatingBit = 0x4000,
                                 kMoreBit = 0x8000;  // of the length field
};

// Read and written in every frame, hence here.
inline DatagramHeader DatagramHeader::read(std::span<const std::uint8_t, kDatagramHeaderSize> bytes) {
  DatagramHeader header;
  header.command = static_cast<Command>(bytes[0]);
  header.index = bytes[1];
  header.address = load_le<std::uint32_t>(bytes.subspan<2, 4>());
  const auto field = load_le<std::uint16_t>(bytes.subspan<kLengthFieldOffset, 2>());
  header.length = field & kLengthMask;
  header.circulating = (field & kCirculatingBit) != 0;
  header.more = (field & kMoreBit) != 0;
  header.irq = load_le<std::uint16_t>(bytes.subspan<kIrqOffset, 2>());
  return header;
}

inline void DatagramHeader::write(std::span<std::uint8_t, kDatagramHeaderSize> bytes) const {
  bytes[0] = static_cast<std::uint8_t>(command);
  bytes[1] = index;
  store_le(bytes.subspan<2, 4>(), address);
  store_le(
      bytes.subspan<kLengthFieldOffset, 2>(),
      static_cast<std::uint16_t>((length & kLengthMask) | (circulating ? kCirculatingBit : 0) | (more ? kMoreBit : 0)));
  store_le(bytes.subspan<kIrqOffset, 2>(), irq);
}

[[nodiscard]] constexpr std::uint32_t device_address(std::uint16_t adp, std::uint16_t ado) {
  return static_cast<std::uint32_t>(adp) | (static_cast<std::uint32_t>(ado) << 16);
}

/// One datagram inside a frame buffer; writes go into the frame.
struct DatagramView {
  DatagramHeader header;
  std::span<std::uint8_t> header_bytes;  // 10
  std::span<std::uint8_t> data;
  std::span<std::uint8_t> wkc_bytes;  // 2

  [[nodiscard]] std::uint16_t wkc() const { return load_le<std::uint16_t>(wkc_bytes); }
  void set_wkc(std::uint16_t value) { store_le(wkc_bytes, value); }
  /// Writes `header` back into header_bytes (the length stays as it is on the wire).
  void store_header() {
    const auto bytes = header_bytes.first<kDatagramHeaderSize>();
    header.length =
        load_le<std::uint16_t>(bytes.subspan<DatagramHeader::kLengthFieldOffset, 2>()) & DatagramHeader::kLengthMask;
    header.write(bytes);
  }
};

}  // namespace syncline
