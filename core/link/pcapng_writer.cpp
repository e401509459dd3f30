// SPDX-License-Identifier: Apache-2.0
#include "link/pcapng_writer.h"

#include <utility>
#include <vector>

#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint32_t kSectionHeader = 0x0A0D0D0A;
constexpr std::uint32_t kInterfaceDescription = 1;
constexpr std::uint32_t kEnhancedPacket = 6;
constexpr std::uint16_t kOptionTimestampResolution = 9;  // if_tsresol
constexpr std::uint16_t kOptionPacketFlags = 2;          // epb_flags
constexpr std::uint16_t kLinkTypeEthernet = 1;

std::size_t padding(std::size_t size) { return (4 - size % 4) % 4; }

/// Block type, total length, body, total length again.
Status write_block(OutputFile& out, std::uint32_t type, const std::vector<std::uint8_t>& body) {
  std::vector<std::uint8_t> block;
  const auto total = static_cast<std::uint32_t>(12 + body.size());
  ByteWriter(block).u32(type).u32(total).bytes(body).u32(total);
  return out.write({reinterpret_cast<const char*>(block.data()), block.size()});
}

}  // namespace

PcapngWriter::PcapngWriter(OutputFile out) : out_(std::move(out)) {
  std::vector<std::uint8_t> section;
  ByteWriter(section).u32(0x1A2B3C4D).u16(1).u16(0).u64(~std::uint64_t{0});  // length not known
  (void)write_block(out_, kSectionHeader, section);                          // an error stays until the next one asks
  std::vector<std::uint8_t> interface;
  ByteWriter(interface).u16(kLinkTypeEthernet).u16(0).u32(0);
  ByteWriter(interface).u16(kOptionTimestampResolution).u16(1).u8(9).zeros(3).u32(0);  // 10^-9 s
  (void)write_block(out_, kInterfaceDescription, interface);
}

Result<PcapngWriter> PcapngWriter::create(const std::string& path) {
  auto out = OutputFile::create(path);
  if (!out) return tl::unexpected(out.error());
  return PcapngWriter(std::move(*out));
}

Status PcapngWriter::write(std::span<const std::uint8_t> frame, Nanoseconds time, Direction direction) {
  const auto unix_time = static_cast<std::uint64_t>(time + kDcEpochUnixSeconds * kSecond);
  const auto size = static_cast<std::uint32_t>(frame.size());
  std::vector<std::uint8_t> body;
  body.reserve(frame.size() + 36);
  ByteWriter(body)
      .u32(0)  // interface
      .u32(static_cast<std::uint32_t>(unix_time >> 32))
      .u32(static_cast<std::uint32_t>(unix_time))
      .u32(size)
      .u32(size)
      .bytes(frame)
      .zeros(padding(frame.size()))
      .u16(kOptionPacketFlags)
      .u16(4)
      .u32(static_cast<std::uint32_t>(direction))
      .u32(0);  // end of options
  return write_block(out_, kEnhancedPacket, body);
}

}  // namespace syncline
