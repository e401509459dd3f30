// SPDX-License-Identifier: Apache-2.0
#include "sim/objects/object_dictionary.h"

#include "protocol/sdo_information.h"

namespace syncline::sim {

ObjectDictionary::Entry& ObjectDictionary::add(std::uint16_t index, std::uint8_t sub_index, std::string name,
                                               std::vector<std::uint8_t> value, bool writable) {
  auto& entry = entries_[{index, sub_index}];
  // A behaviour gives the value; what the ESI said of type and mapping stays.
  Entry fresh;
  fresh.data_type = entry.data_type;
  fresh.extra_access = entry.extra_access;
  if (entry.value.size() == value.size()) fresh.bit_length = entry.bit_length;
  entry = std::move(fresh);
  entry.name = std::move(name);
  entry.initial = value;
  entry.value = std::move(value);
  entry.writable = writable;
  return entry;
}

std::uint16_t ObjectDictionary::Entry::type() const {
  constexpr std::uint16_t kBoolean = 0x01, kUnsigned8 = 0x05, kUnsigned16 = 0x06, kUnsigned32 = 0x07,
                          kUnsigned64 = 0x1B, kOctetString = 0x0A;
  if (data_type != 0) return data_type;
  switch (bits()) {
    case 1:
      return kBoolean;
    case 8:
      return kUnsigned8;
    case 16:
      return kUnsigned16;
    case 32:
      return kUnsigned32;
    case 64:
      return kUnsigned64;
    default:
      return kOctetString;
  }
}

std::uint16_t ObjectDictionary::Entry::access() const {
  std::uint16_t word = extra_access;
  if (readable) word |= coe::access::kRead;
  if (writable) word |= preop_only ? coe::access::kWritePreop : coe::access::kWrite;
  return word;
}

std::vector<std::uint16_t> ObjectDictionary::indices() const {
  std::vector<std::uint16_t> found;
  for (const auto& [address, entry] : entries_) {
    if (found.empty() || found.back() != address.first) found.push_back(address.first);
  }
  return found;
}

std::vector<std::uint8_t> ObjectDictionary::sub_indices(std::uint16_t index) const {
  std::vector<std::uint8_t> found;
  for (auto at = entries_.lower_bound({index, 0}); at != entries_.end() && at->first.first == index; ++at) {
    found.push_back(at->first.second);
  }
  return found;
}

std::string ObjectDictionary::object_name(std::uint16_t index) const {
  if (const auto named = names_.find(index); named != names_.end()) return named->second;
  const auto first = entries_.lower_bound({index, 0});
  return first != entries_.end() && first->first.first == index ? first->second.name : std::string{};
}

ObjectDictionary::Entry* ObjectDictionary::find(std::uint16_t index, std::uint8_t sub_index) {
  const auto found = entries_.find({index, sub_index});
  return found == entries_.end() ? nullptr : &found->second;
}

void ObjectDictionary::remove_object(std::uint16_t index) {
  entries_.erase(entries_.lower_bound({index, 0}), entries_.upper_bound({index, 0xFF}));
}

std::uint32_t ObjectDictionary::missing(std::uint16_t index) const {
  const auto object = entries_.lower_bound({index, 0});
  return object == entries_.end() || object->first.first != index ? abort::kNoObject : abort::kNoSubIndex;
}

std::uint32_t ObjectDictionary::read(std::uint16_t index, std::uint8_t sub_index, std::vector<std::uint8_t>& out) {
  auto* entry = find(index, sub_index);
  if (entry == nullptr) return missing(index);
  if (!entry->readable) return abort::kWriteOnly;
  if (entry->on_read) entry->on_read(*entry);
  out = entry->value;
  return abort::kNone;
}

std::uint32_t ObjectDictionary::write(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> data,
                                      bool in_preop) {
  auto* entry = find(index, sub_index);
  if (entry == nullptr) return missing(index);
  if (!entry->writable) return abort::kReadOnly;
  if (entry->preop_only && !in_preop) return abort::kDeviceState;
  if (data.size() > entry->value.size()) return abort::kTooLong;
  if (data.size() < entry->value.size()) return abort::kTooShort;
  if (entry->on_write) {
    if (const auto code = entry->on_write(data); code != abort::kNone) return code;
  }
  entry->value.assign(data.begin(), data.end());
  return abort::kNone;
}

}  // namespace syncline::sim
