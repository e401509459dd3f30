// SPDX-License-Identifier: Apache-2.0
#include "sim/object_dictionary.h"

namespace syncline::sim {

ObjectDictionary::Entry& ObjectDictionary::add(std::uint16_t index, std::uint8_t sub_index, std::string name,
                                               std::vector<std::uint8_t> value, bool writable) {
  auto& entry = entries_[{index, sub_index}];
  entry = Entry{std::move(name), std::move(value), writable, false, {}, {}};
  return entry;
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
  if (data.size() != entry->value.size()) return abort::kLength;
  if (entry->on_write) {
    if (const auto code = entry->on_write(data); code != abort::kNone) return code;
  }
  entry->value.assign(data.begin(), data.end());
  return abort::kNone;
}

}  // namespace syncline::sim
