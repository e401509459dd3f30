// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "support/byte_order.h"

namespace syncline::sim {

/// Register file and process RAM of an ESC with the access rights that a master sees. An address without
/// a right raises no working counter: registers that an ESC does not implement look like that on the wire.
class EscMemory {
 public:
  static constexpr std::uint32_t kSize = 0x10000;
  static constexpr std::uint32_t kRegisterEnd = 0x1000;
  static constexpr std::uint8_t kRead = 1;
  static constexpr std::uint8_t kWrite = 2;
  static constexpr std::uint8_t kReadWrite = kRead | kWrite;
  static constexpr std::size_t kWord = 8;

  /// `ram_bytes` of process RAM from 0x1000 on.
  explicit EscMemory(std::uint32_t ram_bytes);

  void implement(std::uint16_t address, std::uint16_t length, std::uint8_t rights);
  [[nodiscard]] std::uint8_t rights(std::uint32_t address) const {
    return address < kRegisterEnd ? rights_[address] : (address < ram_end_ ? kReadWrite : std::uint8_t{0});
  }
  /// Whether the master may do this with each byte of at most kWord bytes of registers.
  [[nodiscard]] bool all_have(std::uint8_t right, std::uint32_t address, std::size_t length) const {
    constexpr std::uint64_t kEachByte = 0x0101'0101'0101'0101;
    const auto wanted = (kEachByte * right) >> (8 * (kWord - length));
    return (load_le<std::uint64_t>(std::span(rights_).subspan(address, kWord)) & wanted) == wanted;
  }
  /// The same with any one of any number.
  [[nodiscard]] bool any_have(std::uint8_t right, std::uint32_t address, std::size_t length) const {
    for (std::size_t i = 0; i < length; ++i) {
      if ((rights(static_cast<std::uint32_t>(address + i)) & right) != 0) return true;
    }
    return false;
  }
  /// The usual case: all of it is a register, or all of it is RAM.
  [[nodiscard]] bool is_readable(std::uint32_t address, std::size_t length) const {
    if (address >= kRegisterEnd) return address + length <= ram_end_ && length > 0;
    return length - 1 < kWord && all_have(kRead, address, length);
  }
  [[nodiscard]] std::uint32_t ram_end() const { return ram_end_; }

  [[nodiscard]] std::span<std::uint8_t> at(std::uint32_t address, std::size_t length) {
    return {bytes_ + address, length};
  }
  [[nodiscard]] std::span<const std::uint8_t> at(std::uint32_t address, std::size_t length) const {
    return {bytes_ + address, length};
  }
  template <std::unsigned_integral T>
  [[nodiscard]] T get(std::uint16_t address) const {
    return load_le<T>(at(address, sizeof(T)));
  }
  template <std::unsigned_integral T>
  void set(std::uint16_t address, T value) {
    store_le<T>(at(address, sizeof(T)), value);
  }
  [[nodiscard]] std::uint8_t u8(std::uint16_t address) const { return bytes_[address]; }
  [[nodiscard]] std::uint16_t u16(std::uint16_t address) const { return get<std::uint16_t>(address); }
  [[nodiscard]] std::uint32_t u32(std::uint16_t address) const { return get<std::uint32_t>(address); }
  [[nodiscard]] std::uint64_t u64(std::uint16_t address) const { return get<std::uint64_t>(address); }
  /// Counters of the ESC stop at 0xFF.
  void count(std::uint16_t address) {
    if (bytes_[address] != 0xFF) {
      ++bytes_[address];
    }
  }

 private:
  struct alignas(64) Bytes {  // registers that belong together share a line of the processor's cache
    std::uint8_t bytes[kSize];
  };
  std::unique_ptr<Bytes> memory_;  // a vector's size would be asked for in every access
  std::uint8_t* bytes_;
  std::array<std::uint8_t, kRegisterEnd + kWord> rights_{};
  std::uint32_t ram_end_;
};

}  // namespace syncline::sim
