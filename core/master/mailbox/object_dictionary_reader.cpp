// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/object_dictionary_reader.h"

namespace syncline {

Result<DictionaryObject> ObjectDictionaryReader::read_object(std::uint16_t index) {
  DictionaryObject result;
  result.object.index = index;
  auto object = client_.object(index);
  if (!object) {
    if (object.error().code != ErrorCode::kSdoAbort) return tl::unexpected(object.error());
    result.error = object.error();
    return result;
  }
  result.object = std::move(*object);
  const auto value_info = static_cast<std::uint8_t>(coe::value_info::kUnitType | coe::value_info::kDefault |
                                                    coe::value_info::kMinimum | coe::value_info::kMaximum);
  for (unsigned sub = 0; sub <= result.object.max_sub_index; ++sub) {
    auto entry = client_.entry(index, static_cast<std::uint8_t>(sub), value_info);
    if (entry) {
      result.entries.push_back(std::move(*entry));
    } else if (entry.error().code != ErrorCode::kSdoAbort) {
      return tl::unexpected(entry.error());
    }  // a gap in a record
  }
  return result;
}

Result<std::vector<DictionaryObject>> ObjectDictionaryReader::read(coe::ObjectListType list) {
  const auto indices = client_.object_list(list);
  if (!indices) return tl::unexpected(indices.error());
  std::vector<DictionaryObject> objects;
  for (const auto index : *indices) {
    auto object = read_object(index);
    if (!object) return tl::unexpected(object.error());
    objects.push_back(std::move(*object));
    if (progress_) progress_(objects.size(), indices->size());
  }
  return objects;
}

}  // namespace syncline
