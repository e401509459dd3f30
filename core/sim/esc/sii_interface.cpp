// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/sii_interface.h"

#include <algorithm>

#include "protocol/registers.h"
#include "protocol/sii.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {
namespace {

constexpr std::uint16_t kWriteEnable = 0x0001;
constexpr std::uint16_t kReads8Bytes = 0x0040;
constexpr std::uint16_t kTwoAddressBytes = 0x0080;
constexpr std::uint16_t kCommandMask = 0x0700;
constexpr std::uint16_t kChecksumError = 0x0800;
constexpr std::uint16_t kNotLoaded = 0x1000;
constexpr std::uint16_t kCommandError = 0x2000;
constexpr std::uint16_t kWriteEnableError = 0x4000;
constexpr std::uint16_t kBusy = 0x8000;
constexpr std::uint16_t kSiiRead = 0x0100, kSiiWrite = 0x0200, kSiiReload = 0x0400;
constexpr std::size_t kCheckedBytes = 14;
constexpr std::uint32_t kOneAddressByteSize = 2048;  // 16 kbit and less

}  // namespace

SiiInterface::SiiInterface(std::vector<std::uint8_t> content, const SimSiiConfig& config, EscMemory& memory)
    : memory_(memory), config_(config), content_(std::move(content)) {
  load();
  show(0);
}

bool SiiInterface::checksum_ok() const {
  return content_.size() > kCheckedBytes &&
         sii::checksum(std::span(content_).first(kCheckedBytes)) == content_[kCheckedBytes];
}

void SiiInterface::load() { errors_ = checksum_ok() ? std::uint16_t{0} : std::uint16_t{kChecksumError | kNotLoaded}; }

void SiiInterface::show(std::uint16_t flags) {
  unsigned status = errors_ | flags;
  if (config_.eight_bytes) status |= kReads8Bytes;
  if (content_.size() > kOneAddressByteSize) status |= kTwoAddressBytes;
  memory_.set<std::uint16_t>(reg::kSiiControl, static_cast<std::uint16_t>(status));
}

void SiiInterface::implement_registers() {
  memory_.implement(reg::kSiiConfiguration, 1, EscMemory::kReadWrite);
  memory_.implement(reg::kSiiPdiAccess, 1, EscMemory::kRead);
  memory_.implement(reg::kSiiControl, 14, EscMemory::kReadWrite);
}

bool SiiInterface::blocks(std::uint32_t address) const {
  if (address < reg::kSiiControl || address >= reg::kSiiConfiguration + 16U) return false;
  return done_at_.has_value() || (memory_.u8(reg::kSiiConfiguration) & 0x01) != 0 ||
         (memory_.u8(reg::kSiiPdiAccess) & 0x01) != 0;
}

void SiiInterface::configuration_written() {
  if ((memory_.u8(reg::kSiiConfiguration) & 0x02) != 0) memory_.set<std::uint8_t>(reg::kSiiPdiAccess, 0);
}

void SiiInterface::control_written(Nanoseconds time) {
  const auto control = memory_.u16(reg::kSiiControl);
  command_ = control & kCommandMask;
  errors_ &= static_cast<std::uint16_t>(~(kCommandError | kWriteEnableError));
  if (command_ == kSiiWrite && (control & kWriteEnable) == 0) {
    errors_ |= kWriteEnableError;
    command_ = 0;
  }
  if (command_ == 0) return show(0);
  done_at_ = time + (command_ == kSiiWrite ? config_.write_time : config_.read_time);
  show(static_cast<std::uint16_t>(kBusy | command_));
}

bool SiiInterface::advance_to(Nanoseconds time) {
  if (!done_at_ || time < *done_at_) return false;
  done_at_.reset();
  const auto command = command_;
  execute(command);
  command_ = 0;
  show(0);
  return command == kSiiReload && checksum_ok();
}

void SiiInterface::execute(std::uint16_t command) {
  const auto word = memory_.u32(reg::kSiiAddress);
  const bool there = !content_.empty();  // else nobody answers on its wires
  if (there && command == kSiiRead) {
    read(word);
  } else if (there && command == kSiiReload) {
    load();
  } else if (there && command == kSiiWrite && 2ULL * word + 1 < content_.size()) {
    std::copy_n(memory_.at(reg::kSiiData, 2).begin(), 2, content_.begin() + std::ptrdiff_t{2} * word);
  } else {
    errors_ |= kCommandError;
  }
}

void SiiInterface::read(std::uint32_t word) {
  auto data = memory_.at(reg::kSiiData, config_.eight_bytes ? 8 : 4);
  for (std::size_t i = 0; i < data.size(); ++i) {
    const auto address = 2ULL * word + i;
    data[i] = address < content_.size() ? content_[address] : std::uint8_t{0xFF};
  }
}

}  // namespace syncline::sim
