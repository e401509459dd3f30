// SPDX-License-Identifier: Apache-2.0
#include "sim/mailbox/complete_access.h"

#include <algorithm>

#include "protocol/coe.h"
#include "sim/objects/object_dictionary.h"
#include "sim/objects/pdo_objects.h"

namespace syncline::sim {
namespace {

constexpr std::size_t kCountBits = 16;  // the number of entries and a byte of padding

std::uint8_t entry_count(ObjectDictionary& dictionary, std::uint16_t index) {
  return dictionary.get<std::uint8_t>(index, 0);
}

void append_bits(std::vector<std::uint8_t>& out, std::size_t& used, std::span<const std::uint8_t> value,
                 std::size_t bits) {
  out.resize((used + bits + 7) / 8);
  copy_bits(out, used, value, 0, bits);
  used += bits;
}

}  // namespace

std::uint32_t read_complete(ObjectDictionary& dictionary, const coe::ObjectAddress& object,
                            std::vector<std::uint8_t>& out) {
  const auto subs = dictionary.sub_indices(object.index);
  if (subs.empty()) return abort::kNoObject;
  if (subs.back() == 0) {  // a variable is its own image
    return object.sub_index == 0 ? dictionary.read(object.index, 0, out) : abort::kNoSubIndex;
  }
  const auto count = entry_count(dictionary, object.index);
  std::size_t used = 0;
  out.clear();
  if (object.sub_index == 0) append_bits(out, used, std::array<std::uint8_t, 2>{count, 0}, kCountBits);
  for (const auto sub : subs) {
    if (sub == 0 || sub > count) continue;
    std::vector<std::uint8_t> value;
    if (const auto code = dictionary.read(object.index, sub, value); code != abort::kNone) return code;
    append_bits(out, used, value, dictionary.find(object.index, sub)->bits());
  }
  return abort::kNone;
}

std::uint32_t write_complete(ObjectDictionary& dictionary, const coe::ObjectAddress& object,
                             std::span<const std::uint8_t> image, bool in_preop) {
  const auto subs = dictionary.sub_indices(object.index);
  if (subs.empty()) return abort::kNoObject;
  if (subs.back() == 0) {
    return object.sub_index == 0 ? dictionary.write(object.index, 0, image, in_preop) : abort::kNoSubIndex;
  }
  auto* const head = dictionary.find(object.index, 0);
  const bool counted = head != nullptr && head->writable;
  auto count = entry_count(dictionary, object.index);
  std::size_t bit = 0;
  if (object.sub_index == 0) {
    if (image.size() < 2) return abort::kTooShort;
    if (!counted && image[0] != count) return abort::kReadOnly;
    count = image[0];
    bit = kCountBits;
  }
  if (counted) {
    const std::uint8_t none[] = {0};
    if (const auto code = dictionary.write(object.index, 0, none, in_preop); code != abort::kNone) return code;
  }
  for (const auto sub : subs) {
    if (sub == 0 || sub > count) continue;
    auto* entry = dictionary.find(object.index, sub);
    const auto bits = entry->bits();
    if (bit + bits > 8 * image.size()) return abort::kTooShort;
    std::vector<std::uint8_t> value(entry->value.size());
    copy_bits(value, 0, image, bit, std::min(bits, 8 * value.size()));
    bit += bits;
    if (!entry->writable) continue;  // its place is in the image all the same
    if (const auto code = dictionary.write(object.index, sub, value, in_preop); code != abort::kNone) return code;
  }
  if (count > subs.back()) return abort::kNoSubIndex;
  if ((bit + 7) / 8 < image.size()) return abort::kTooLong;
  if (!counted) return abort::kNone;
  const std::uint8_t number[] = {count};
  return dictionary.write(object.index, 0, number, in_preop);
}

}  // namespace syncline::sim
