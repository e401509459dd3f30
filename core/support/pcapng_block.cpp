// SPDX-License-Identifier: Apache-2.0
#include "support/pcapng_block.h"

#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::uint32_t kSectionHeader = 0x0A0D0D0A, kInterfaceDescription = 1, kInterfaceStatistics = 5,
                        kEnhancedPacket = 6;
constexpr std::uint32_t kByteOrderMagic = 0x1A2B3C4D;
constexpr std::uint16_t kLinkTypeEthernet = 1;
constexpr std::uint8_t kNanosecondResolution = 9;  // 10^-9 s
// Options, by their blocks.
constexpr std::uint16_t kEndOfOptions = 0, kComment = 1;
constexpr std::uint16_t kApplication = 4;
constexpr std::uint16_t kInterfaceName = 2, kInterfaceText = 3, kTimestampResolution = 9;
constexpr std::uint16_t kPacketFlags = 2, kPacketLosses = 4;
constexpr std::uint16_t kBegin = 2, kEnd = 3, kReceived = 4, kLost = 5;

constexpr std::size_t kFrame = 12;         // type, length and length again
constexpr std::size_t kPacketFields = 20;  // interface, time, both lengths
constexpr std::size_t kFlagsOption = 8, kOptionsEnd = 4;

constexpr std::size_t padding(std::size_t size) { return (4 - size % 4) % 4; }

/// Type, total length, what is written until end(), total length again. What did not get so far is taken back: there
/// was no memory for the rest.
class Block {
 public:
  Block(std::vector<std::uint8_t>& out, std::uint32_t type) : out_(out), begin_(out.size()), writer_(out) {
    writer_.u32(type).u32(0);
  }
  ~Block() {
    if (!ended_) out_.erase(out_.begin() + static_cast<std::ptrdiff_t>(begin_), out_.end());
  }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;

  ByteWriter& fields() { return writer_; }
  ByteWriter& option(std::uint16_t code, std::size_t size) {
    return writer_.u16(code).u16(static_cast<std::uint16_t>(size));
  }
  void text(std::uint16_t code, std::string_view words) {
    constexpr std::size_t kMost = 0xFFFF;
    words = words.substr(0, kMost);
    if (words.empty()) return;
    option(code, words.size())
        .bytes({reinterpret_cast<const std::uint8_t*>(words.data()), words.size()})
        .zeros(padding(words.size()));
  }
  void notes(std::span<const std::string> all) {
    for (const auto& note : all) text(kComment, note);
  }
  void time(Nanoseconds since_dc_epoch) {
    const auto unix_time = static_cast<std::uint64_t>(since_dc_epoch + kDcEpochUnixSeconds * kSecond);
    writer_.u32(static_cast<std::uint32_t>(unix_time >> 32)).u32(static_cast<std::uint32_t>(unix_time));
  }
  void end_options() { option(kEndOfOptions, 0); }
  void end() {
    const auto total = static_cast<std::uint32_t>(out_.size() - begin_ + 4);
    writer_.u32(total);
    store_le(std::span(out_).subspan(begin_ + 4, 4), total);
    ended_ = true;
  }

 private:
  std::vector<std::uint8_t>& out_;
  std::size_t begin_;
  ByteWriter writer_;
  bool ended_ = false;
};

}  // namespace

void append_pcapng_section(std::vector<std::uint8_t>& out, std::string_view application) {
  Block block(out, kSectionHeader);
  block.fields().u32(kByteOrderMagic).u16(1).u16(0).u64(~std::uint64_t{0});  // length not known
  if (!application.empty()) {
    block.text(kApplication, application);
    block.end_options();
  }
  block.end();
}

void append_pcapng_interface(std::vector<std::uint8_t>& out, std::string_view name, std::string_view description) {
  Block block(out, kInterfaceDescription);
  block.fields().u16(kLinkTypeEthernet).u16(0).u32(0);  // no limit to a packet's length
  block.text(kInterfaceName, name);
  block.text(kInterfaceText, description);
  block.option(kTimestampResolution, 1).u8(kNanosecondResolution).zeros(padding(1));
  block.end_options();
  block.end();
}

void append_pcapng_packet(std::vector<std::uint8_t>& out, const PcapngPacket& packet) {
  Block block(out, kEnhancedPacket);
  const auto size = static_cast<std::uint32_t>(packet.bytes.size());
  block.fields().u32(0);  // interface
  block.time(packet.time);
  block.fields().u32(size).u32(size).bytes(packet.bytes).zeros(padding(size));
  block.notes(packet.notes);
  block.option(kPacketFlags, 4).u32(packet.direction);
  if (packet.lost_before > 0) block.option(kPacketLosses, 8).u64(packet.lost_before);
  block.end_options();
  block.end();
}

std::size_t pcapng_packet_size(std::size_t bytes) {
  return kFrame + kPacketFields + bytes + padding(bytes) + kFlagsOption + kOptionsEnd;
}

void append_pcapng_statistics(std::vector<std::uint8_t>& out, const PcapngStatistics& statistics) {
  Block block(out, kInterfaceStatistics);
  block.fields().u32(0);  // interface
  block.time(statistics.end);
  block.notes(statistics.notes);
  block.option(kBegin, 8);
  block.time(statistics.begin);
  block.option(kEnd, 8);
  block.time(statistics.end);
  block.option(kReceived, 8).u64(statistics.received);
  block.option(kLost, 8).u64(statistics.lost);
  block.end_options();
  block.end();
}

}  // namespace syncline
