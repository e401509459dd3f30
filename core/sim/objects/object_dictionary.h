// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/byte_order.h"

namespace syncline::sim {

/// CoE abort codes that the server answers with (ETG.1000.6, table 41).
namespace abort {
inline constexpr std::uint32_t kNone = 0;
inline constexpr std::uint32_t kToggle = 0x05030000;
inline constexpr std::uint32_t kCommand = 0x05040001;
inline constexpr std::uint32_t kOutOfMemory = 0x05040005;
inline constexpr std::uint32_t kUnsupportedAccess = 0x06010000;
inline constexpr std::uint32_t kWriteOnly = 0x06010001;
inline constexpr std::uint32_t kReadOnly = 0x06010002;
inline constexpr std::uint32_t kSubIndexNotWritable = 0x06010003;
inline constexpr std::uint32_t kNoCompleteAccess = 0x06010004;
inline constexpr std::uint32_t kNoObject = 0x06020000;
inline constexpr std::uint32_t kNotMappable = 0x06040041;
inline constexpr std::uint32_t kPdoTooLong = 0x06040042;
inline constexpr std::uint32_t kLength = 0x06070010;
inline constexpr std::uint32_t kTooLong = 0x06070012;
inline constexpr std::uint32_t kTooShort = 0x06070013;
inline constexpr std::uint32_t kNoSubIndex = 0x06090011;
inline constexpr std::uint32_t kRange = 0x06090030;
inline constexpr std::uint32_t kDeviceState = 0x08000022;
}  // namespace abort

/// Object dictionary of a simulated device. Values are little-endian bytes.
class ObjectDictionary {
 public:
  struct Entry {
    std::string name;
    std::vector<std::uint8_t> value;
    bool writable = false;
    bool preop_only = false;  // writable in PREOP only
    /// Asked before a new value is taken; an abort code, or 0. The hook may store something else.
    std::function<std::uint32_t(std::span<const std::uint8_t>)> on_write;
    std::function<void(Entry&)> on_read;  // refreshes the value
    std::vector<std::uint8_t> initial;    // value after power-on
    bool readable = true;
    std::uint16_t bit_length = 0;    // 0: all bits of the value
    std::uint16_t data_type = 0;     // ETG.1000.6, table 64; 0: by the value's length
    std::uint16_t extra_access = 0;  // mappable, backup, settings (coe::access)

    [[nodiscard]] std::size_t bits() const { return bit_length != 0 ? bit_length : 8 * value.size(); }
    [[nodiscard]] std::uint16_t type() const;
    /// Access word of SDO information (ETG.1000.6, table 48).
    [[nodiscard]] std::uint16_t access() const;
  };

  Entry& add(std::uint16_t index, std::uint8_t sub_index, std::string name, std::vector<std::uint8_t> value,
             bool writable = false);
  template <std::unsigned_integral T>
  Entry& add(std::uint16_t index, std::uint8_t sub_index, std::string name, T value, bool writable = false) {
    return add(index, sub_index, std::move(name), le_bytes(value), writable);
  }
  [[nodiscard]] Entry* find(std::uint16_t index, std::uint8_t sub_index);
  void remove_object(std::uint16_t index);
  [[nodiscard]] std::vector<std::uint16_t> indices() const;                        // ascending
  [[nodiscard]] std::vector<std::uint8_t> sub_indices(std::uint16_t index) const;  // ascending; empty: no such object
  /// Of the whole object; where none was given, that of its first entry.
  [[nodiscard]] std::string object_name(std::uint16_t index) const;
  void set_object_name(std::uint16_t index, std::string name) { names_[index] = std::move(name); }
  /// Where nobody has named it.
  void suggest_object_name(std::uint16_t index, const std::string& name) { names_.try_emplace(index, name); }

  template <std::unsigned_integral T>
  [[nodiscard]] T get(std::uint16_t index, std::uint8_t sub_index, T missing = 0) {
    const auto* entry = find(index, sub_index);
    return entry != nullptr && entry->value.size() >= sizeof(T) ? load_le<T>(entry->value) : missing;
  }
  template <std::unsigned_integral T>
  void set(std::uint16_t index, std::uint8_t sub_index, T value) {
    if (auto* entry = find(index, sub_index)) entry->value = le_bytes(value);
  }

  /// SDO access; an abort code or 0.
  std::uint32_t read(std::uint16_t index, std::uint8_t sub_index, std::vector<std::uint8_t>& out);
  std::uint32_t write(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> data, bool in_preop);

 private:
  [[nodiscard]] std::uint32_t missing(std::uint16_t index) const;
  std::map<std::pair<std::uint16_t, std::uint8_t>, Entry> entries_;
  std::map<std::uint16_t, std::string> names_;
};

}  // namespace syncline::sim
