// SPDX-License-Identifier: Apache-2.0
#include "protocol/frame.h"

#include <algorithm>

#include "protocol/datagram.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint16_t kLengthMask = 0x07FF;  // of the EtherCAT header
constexpr std::uint16_t kTypeCommands = 1;
constexpr std::size_t kEtherTypeOffset = 12;
constexpr std::uint16_t kVlanEtherType = 0x8100;
constexpr std::size_t kVlanTagSize = 4;

/// EtherType fields are the only ones in network order.
std::uint16_t load_be16(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return static_cast<std::uint16_t>((bytes[offset] << 8) | bytes[offset + 1]);
}

}  // namespace

FrameBuilder::FrameBuilder() {
  std::fill_n(buffer_.begin(), 6, std::uint8_t{0xFF});
  buffer_[kEtherTypeOffset] = kEtherCatEtherType >> 8;
  buffer_[kEtherTypeOffset + 1] = kEtherCatEtherType & 0xFF;
  reset();
}

void FrameBuilder::reset() {
  size_ = kFrameOverhead;
  count_ = 0;
  last_length_field_ = 0;
}

void FrameBuilder::set_addresses(std::span<const std::uint8_t, 6> destination,
                                 std::span<const std::uint8_t, 6> source) {
  std::copy(destination.begin(), destination.end(), buffer_.begin());
  std::copy(source.begin(), source.end(), buffer_.begin() + 6);
}

std::optional<std::span<std::uint8_t>> FrameBuilder::add_zeros(Command command, std::uint8_t index,
                                                               std::uint32_t address, std::uint16_t length) {
  const std::size_t end = size_ + kDatagramOverhead + length;
  if (end > kMaxEthernetFrame) return std::nullopt;
  const std::span<std::uint8_t> all(buffer_);
  if (count_ > 0) all[last_length_field_ + 1] |= static_cast<std::uint8_t>(DatagramHeader::kMoreBit >> 8);

  DatagramHeader header;
  header.command = command;
  header.index = index;
  header.address = address;
  header.length = length;
  header.write(all.subspan(size_).first<kDatagramHeaderSize>());
  const auto data = all.subspan(size_ + kDatagramHeaderSize, length);
  std::fill_n(all.begin() + static_cast<std::ptrdiff_t>(size_ + kDatagramHeaderSize), length + kWkcSize,
              std::uint8_t{0});
  last_length_field_ = size_ + DatagramHeader::kLengthFieldOffset;
  size_ = end;
  ++count_;
  return data;
}

std::optional<std::span<std::uint8_t>> FrameBuilder::add(Command command, std::uint8_t index, std::uint32_t address,
                                                         std::span<const std::uint8_t> data) {
  if (data.size() > kMaxDatagramData) return std::nullopt;
  const auto area = add_zeros(command, index, address, static_cast<std::uint16_t>(data.size()));
  if (area) std::copy(data.begin(), data.end(), area->begin());
  return area;
}

std::span<const std::uint8_t> FrameBuilder::finish() {
  const std::span<std::uint8_t> all(buffer_);
  const auto length = static_cast<std::uint16_t>(size_ - kFrameOverhead);
  store_le(all.subspan(kEthernetHeaderSize), static_cast<std::uint16_t>(length | (kTypeCommands << 12)));
  const std::size_t padded = std::max(size_, kMinEthernetFrame);
  std::fill(buffer_.begin() + static_cast<std::ptrdiff_t>(size_), buffer_.begin() + static_cast<std::ptrdiff_t>(padded),
            std::uint8_t{0});
  return all.first(padded);
}

FrameReader::FrameReader(std::span<std::uint8_t> frame, LengthField length_field) {
  std::size_t header = kEthernetHeaderSize;
  if (frame.size() < header) return;
  auto ether_type = load_be16(frame, kEtherTypeOffset);
  if (ether_type == kVlanEtherType) {
    header += kVlanTagSize;
    if (frame.size() < header) return;
    ether_type = load_be16(frame, kEtherTypeOffset + kVlanTagSize);
  }
  if (ether_type != kEtherCatEtherType) return;
  if (frame.size() < header + kEtherCatHeaderSize) {
    malformed_ = true;
    return;
  }
  const auto field = load_le<std::uint16_t>(frame.subspan(header));
  const auto rest = frame.subspan(header + kEtherCatHeaderSize);
  const std::size_t length = length_field == LengthField::kIgnored ? rest.size() : field & kLengthMask;
  if ((field >> 12) != kTypeCommands) return;
  if (length > rest.size()) {
    malformed_ = true;
    return;
  }
  body_ = rest.first(length);
  is_ethercat_ = true;
}

std::optional<DatagramView> FrameReader::next() {
  if (!is_ethercat_ || malformed_) [[unlikely]]
    return std::nullopt;
  const auto left = body_.subspan(position_);
  // Bytes behind the last datagram are padding: some masters round the frame's length field up.
  if (last_seen_ || (left.empty() && position_ == 0)) return std::nullopt;
  if (left.size() < kDatagramOverhead) [[unlikely]] {
    malformed_ = true;
    return std::nullopt;
  }
  const auto header = DatagramHeader::read(left.first<kDatagramHeaderSize>());
  if (left.size() < kDatagramOverhead + header.length) [[unlikely]] {
    malformed_ = true;
    return std::nullopt;
  }
  position_ += kDatagramOverhead + header.length;
  last_seen_ = !header.more;
  auto* const begin = left.data();
  return DatagramView{header,
                      {begin, kDatagramHeaderSize},
                      {begin + kDatagramHeaderSize, header.length},
                      {begin + kDatagramHeaderSize + header.length, kWkcSize}};
}

}  // namespace syncline
