// SPDX-License-Identifier: Apache-2.0
#include "sim/sii_interface.h"

#include <algorithm>

#include "protocol/registers.h"
#include "protocol/sii.h"

namespace syncline::sim {
namespace {

constexpr std::uint16_t kWriteEnable = 0x0001;
constexpr std::uint16_t kReads8Bytes = 0x0040;
constexpr std::uint16_t kTwoAddressBytes = 0x0080;
constexpr std::uint16_t kChecksumError = 0x0800;
constexpr std::uint16_t kCommandError = 0x2000;
constexpr std::uint16_t kWriteEnableError = 0x4000;
constexpr unsigned kReadCommand = 1, kWriteCommand = 2, kReloadCommand = 4;

}  // namespace

SiiInterface::SiiInterface(std::vector<std::uint8_t> content, EscMemory& memory)
    : memory_(memory), content_(std::move(content)) {
  std::uint16_t status = kReads8Bytes | kTwoAddressBytes;
  if (content_.size() < 16 || sii::checksum(std::span(content_).first(14)) != content_[14]) status |= kChecksumError;
  memory_.set<std::uint16_t>(reg::kSiiControl, status);
}

void SiiInterface::read(std::uint32_t word) {
  auto data = memory_.at(reg::kSiiData, 8);
  for (std::size_t i = 0; i < data.size(); ++i) {
    const auto address = 2ULL * word + i;
    data[i] = address < content_.size() ? content_[address] : std::uint8_t{0xFF};
  }
}

void SiiInterface::control_written() {
  const auto control = memory_.u16(reg::kSiiControl);
  const auto word = memory_.u32(reg::kSiiAddress);
  std::uint16_t status = kReads8Bytes | kTwoAddressBytes;
  switch ((control >> 8) & 0x07) {
    case 0: break;
    case kReadCommand: read(word); break;
    case kReloadCommand: break;
    case kWriteCommand:
      if ((control & kWriteEnable) == 0) {
        status |= kWriteEnableError;
      } else if (2ULL * word + 1 < content_.size()) {
        std::copy_n(memory_.at(reg::kSiiData, 2).begin(), 2, content_.begin() + static_cast<std::ptrdiff_t>(2 * word));
      } else {
        status |= kCommandError;
      }
      break;
    default: status |= kCommandError; break;
  }
  memory_.set<std::uint16_t>(reg::kSiiControl, status);
}

}  // namespace syncline::sim
