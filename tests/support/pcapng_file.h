// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "support/byte_order.h"
#include "support/text_bytes.h"
#include "support/types.h"
#include "support/whole_file.h"

/// Blocks of pcapng as the draft says, read without the code that writes them.
namespace syncline::test {

struct PcapngBlock {
  std::uint32_t type = 0;
  std::vector<std::uint8_t> body;
  std::size_t end = 0;                                    // in the file
  std::multimap<int, std::vector<std::uint8_t>> options;  // of a packet or of statistics
  std::vector<std::uint8_t> frame;                        // of a packet
  Nanoseconds time = 0;                                   // of a packet, since the DC epoch
  [[nodiscard]] std::vector<std::string> comments() const {
    std::vector<std::string> found;
    const auto [begin, last] = options.equal_range(1);
    for (auto it = begin; it != last; ++it) found.emplace_back(it->second.begin(), it->second.end());
    return found;
  }
  /// 4 or 8 bytes; 0: there is none.
  [[nodiscard]] std::uint64_t number(int option) const {
    const auto found = options.find(option);
    if (found == options.end()) return 0;
    return found->second.size() == 8 ? load_le<std::uint64_t>(found->second) : load_le<std::uint32_t>(found->second);
  }
};

inline constexpr std::uint32_t kSectionBlock = 0x0A0D0D0A, kInterfaceBlock = 1, kStatisticsBlock = 5, kPacketBlock = 6;

inline void read_options(PcapngBlock& block, std::span<const std::uint8_t> bytes) {
  while (bytes.size() >= 4) {
    const auto code = load_le<std::uint16_t>(bytes), size = load_le<std::uint16_t>(bytes.subspan(2));
    if (code == 0) return;
    const auto value = bytes.subspan(4, size);
    block.options.emplace(code, std::vector<std::uint8_t>(value.begin(), value.end()));
    bytes = bytes.subspan(4 + (std::size_t{size} + 3) / 4 * 4);
  }
}

/// Complete blocks from the begin; what is behind them is left.
inline std::vector<PcapngBlock> pcapng_blocks(std::span<const std::uint8_t> all) {
  std::vector<PcapngBlock> blocks;
  std::size_t at = 0;
  while (all.size() - at >= 12) {
    const auto size = load_le<std::uint32_t>(all.subspan(at + 4));
    if (size < 12 || size % 4 != 0 || size > all.size() - at) break;
    if (load_le<std::uint32_t>(all.subspan(at + size - 4)) != size) break;
    auto& block = blocks.emplace_back();
    block.type = load_le<std::uint32_t>(all.subspan(at));
    const auto body = all.subspan(at + 8, size - 12);
    block.body.assign(body.begin(), body.end());
    at += size;
    block.end = at;
    if (block.type == kStatisticsBlock) read_options(block, body.subspan(12));
    if (block.type != kPacketBlock) continue;
    const auto unix_time =
        std::uint64_t{load_le<std::uint32_t>(body.subspan(4))} << 32U | load_le<std::uint32_t>(body.subspan(8));
    block.time = static_cast<Nanoseconds>(unix_time) - kDcEpochUnixSeconds * kSecond;
    const auto length = load_le<std::uint32_t>(body.subspan(12));
    block.frame.assign(body.begin() + 20, body.begin() + 20 + length);
    read_options(block, body.subspan(20 + (std::size_t{length} + 3) / 4 * 4));
  }
  return blocks;
}

/// By name, which is by number.
inline std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  return files;
}

inline std::vector<PcapngBlock> packets_in(const std::vector<std::string>& files) {
  std::vector<PcapngBlock> packets;
  for (const auto& file : files) {
    const auto text = read_whole_file(file).value_or("");
    for (auto& block : pcapng_blocks(bytes_of(text))) {
      if (block.type == kPacketBlock) packets.push_back(std::move(block));
    }
  }
  return packets;
}

}  // namespace syncline::test
