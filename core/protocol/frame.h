// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/command.h"
#include "protocol/datagram.h"

namespace syncline {

struct DatagramView;

inline constexpr std::size_t kEthernetHeaderSize = 14;
inline constexpr std::size_t kEtherCatHeaderSize = 2;
/// What a frame has before its first datagram.
inline constexpr std::size_t kFrameOverhead = kEthernetHeaderSize + kEtherCatHeaderSize;
inline constexpr std::size_t kMaxEthernetFrame = 1514;  // without FCS
inline constexpr std::size_t kMinEthernetFrame = 60;    // without FCS
inline constexpr std::size_t kMaxDatagramData = kMaxEthernetFrame - kFrameOverhead - kDatagramOverhead;
/// Bytes of all datagrams of one frame, at most.
inline constexpr std::size_t kMaxDatagramBytes = kMaxEthernetFrame - kFrameOverhead;
inline constexpr std::size_t kFrameCheckSequence = 4;
inline constexpr std::uint16_t kEtherCatEtherType = 0x88A4;

/// Assembles one EtherCAT frame in a buffer of its own; no allocation. Datagrams are added in wire
/// order; add() gives nothing when the datagram does not fit any more.
class FrameBuilder {
 public:
  FrameBuilder();
  void reset();
  void set_addresses(std::span<const std::uint8_t, 6> destination, std::span<const std::uint8_t, 6> source);

  /// Adds a datagram with `data`; returns the data area inside the frame, empty optional when it
  /// does not fit. Zero-length data is legal.
  std::optional<std::span<std::uint8_t>> add(Command command, std::uint8_t index, std::uint32_t address,
                                             std::span<const std::uint8_t> data);
  /// Same, with `length` zero bytes.
  std::optional<std::span<std::uint8_t>> add_zeros(Command command, std::uint8_t index, std::uint32_t address,
                                                   std::uint16_t length);
  [[nodiscard]] std::size_t datagram_count() const { return count_; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Writes the EtherCAT header, clears the last "more" bit, pads to 60 bytes and returns the frame.
  /// The span is valid until the next reset().
  std::span<const std::uint8_t> finish();

 private:
  std::array<std::uint8_t, kMaxEthernetFrame> buffer_{};
  std::size_t size_ = 0;
  std::size_t last_length_field_ = 0;
  std::size_t count_ = 0;
};

/// Walks the datagrams of a received frame. Never reads outside the buffer; a frame that lies
/// about lengths ends the walk with malformed() == true.
class FrameReader {
 public:
  /// What the length in the EtherCAT header is good for. ESCs do not look at it: they follow the lengths of the
  /// datagrams (ESC data sheet I, 2.3: frame header), so that masters that write a wrong one are served.
  enum class LengthField : std::uint8_t { kChecked, kIgnored };
  /// `frame` starts with the Ethernet header (an 802.1Q tag is skipped).
  explicit FrameReader(std::span<std::uint8_t> frame, LengthField length_field = LengthField::kChecked);
  /// True when EtherType, EtherCAT type and length field are right.
  [[nodiscard]] bool is_ethercat() const { return is_ethercat_; }
  [[nodiscard]] bool malformed() const { return malformed_; }
  std::optional<DatagramView> next();

 private:
  std::span<std::uint8_t> body_;
  std::size_t position_ = 0;
  bool is_ethercat_ = false;
  bool malformed_ = false;
  bool last_seen_ = false;
};

/// A byte on a 100 Mbit/s wire, ns.
inline constexpr std::int64_t kWireByteTime = 80;

/// Wire time of a frame of `frame_bytes` (Ethernet header to last payload byte, no FCS) at
/// 100 Mbit/s with preamble, FCS and inter-frame gap, ns.
[[nodiscard]] constexpr std::int64_t wire_time_ns(std::size_t frame_bytes) {
  const std::size_t padded = frame_bytes < kMinEthernetFrame ? kMinEthernetFrame : frame_bytes;
  return static_cast<std::int64_t>(8 + padded + kFrameCheckSequence + 12) * kWireByteTime;
}

}  // namespace syncline
