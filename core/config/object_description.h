// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Profile and object dictionary as the ESI describes them.
namespace syncline {

struct ChannelProfile {
  std::uint32_t profile_no = 0;
  std::uint32_t add_info = 0;
  bool operator==(const ChannelProfile&) const = default;
};

enum class ObjectCategory : std::uint8_t { kOptional = 0, kMandatory = 1, kConditional = 2 };
enum class ObjectCode : std::uint8_t { kVariable = 7, kArray = 8, kRecord = 9 };

struct ObjectEntry {
  std::uint8_t sub_index = 0;
  std::string name;
  std::string data_type;
  std::uint16_t bit_length = 0;
  bool readable = true;
  bool writable = false;
  std::vector<std::uint8_t> default_data;            // little endian; empty = zeros
  std::vector<std::uint8_t> min_data{}, max_data{};  // little endian; empty = not limited
  bool rx_mappable = false, tx_mappable = false;     // Flags/PdoMapping
  ObjectCategory category = ObjectCategory::kOptional;
  bool backup = false;  // is stored and restored
  bool setting = false;
  /// States in which access is restricted to, as ESI writes them: "PreOP", "PreOP_SafeOP" ...; empty = all
  std::string read_restrictions{}, write_restrictions{};
  std::uint32_t bit_offset = 0;  // in the object's complete access image
  bool operator==(const ObjectEntry&) const = default;
};
struct ObjectDescription {
  std::uint16_t index = 0;
  std::string name;
  std::vector<ObjectEntry> entries;  // sub-index ascending
  ObjectCode code = ObjectCode::kVariable;
  bool depend_on_slot = false;  // in modules: SlotIndexIncrement is added to `index` for each slot
  bool depend_on_slot_group = false;
  bool overwritten_by_module = false;
  bool operator==(const ObjectDescription&) const = default;
};

/// Data type of the dictionary whose values have names.
struct EnumValue {
  std::int64_t value = 0;
  std::string text{};
  bool operator==(const EnumValue&) const = default;
};
struct EnumDescription {
  std::string name{};  // data type, as ObjectEntry::data_type refers to it
  std::string base_type{};
  std::uint16_t bit_length = 0;
  std::vector<EnumValue> values{};
  bool operator==(const EnumDescription&) const = default;
};

}  // namespace syncline
