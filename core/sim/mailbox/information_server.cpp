// SPDX-License-Identifier: Apache-2.0
#include "sim/mailbox/information_server.h"

#include <algorithm>

namespace syncline::sim {
namespace {

using coe::ObjectListType;

constexpr ObjectListType kLists[] = {ObjectListType::kAll, ObjectListType::kRxPdo, ObjectListType::kTxPdo,
                                     ObjectListType::kStored, ObjectListType::kStartup};

/// Bit of the access word that puts an object into the list.
std::uint16_t access_bit(ObjectListType type) {
  switch (type) {
    case ObjectListType::kRxPdo:
      return coe::access::kRxPdo;
    case ObjectListType::kTxPdo:
      return coe::access::kTxPdo;
    case ObjectListType::kStored:
      return coe::access::kBackup;
    case ObjectListType::kStartup:
      return coe::access::kSettings;
    default:
      return 0;
  }
}

}  // namespace

coe::InformationResponse InformationServer::respond(const coe::InformationRequest& request) {
  if (const auto* r = std::get_if<coe::ObjectListRequest>(&request)) return object_list(r->list);
  if (const auto* r = std::get_if<coe::ObjectDescriptionRequest>(&request)) return object(r->index);
  return entry(std::get<coe::EntryDescriptionRequest>(request));
}

std::vector<std::uint16_t> InformationServer::list(ObjectListType type) {
  auto indices = dictionary_.indices();
  if (type == ObjectListType::kAll) return indices;
  std::erase_if(indices, [&](std::uint16_t index) {
    return std::ranges::none_of(dictionary_.sub_indices(index), [&](std::uint8_t sub) {
      const auto* found = dictionary_.find(index, sub);
      return found != nullptr && (found->access() & access_bit(type)) != 0;
    });
  });
  return indices;
}

coe::InformationResponse InformationServer::object_list(ObjectListType type) {
  coe::ObjectList response{type, {}};
  if (type == ObjectListType::kLengths) {
    for (const auto one : kLists) response.indices.push_back(static_cast<std::uint16_t>(list(one).size()));
    return response;
  }
  if (std::ranges::find(kLists, type) == std::end(kLists)) return coe::InformationError{abort::kUnsupportedAccess};
  response.indices = list(type);
  return response;
}

coe::InformationResponse InformationServer::object(std::uint16_t index) {
  const auto subs = dictionary_.sub_indices(index);
  if (subs.empty()) return coe::InformationError{abort::kNoObject};
  coe::ObjectDescription response;
  response.index = index;
  response.max_sub_index = subs.back();
  response.code = subs.back() == 0 ? coe::ObjectCode::kVariable : coe::ObjectCode::kRecord;
  if (const auto* first = dictionary_.find(index, subs.front())) response.data_type = first->type();
  response.name = dictionary_.object_name(index);
  return response;
}

coe::InformationResponse InformationServer::entry(const coe::EntryDescriptionRequest& request) {
  auto* found = dictionary_.find(request.index, request.sub_index);
  coe::EntryDescription response;
  response.index = request.index;
  response.sub_index = request.sub_index;
  if (found == nullptr) {
    const auto subs = dictionary_.sub_indices(request.index);
    if (subs.empty()) return coe::InformationError{abort::kNoObject};
    if (request.sub_index > subs.back()) return coe::InformationError{abort::kNoSubIndex};
    return response;  // a gap, as the usual slave stack code describes it: no type, no length, no access
  }
  response.data_type = found->type();
  response.bit_length = static_cast<std::uint16_t>(found->bits());
  response.access = found->access();
  response.value_info = request.value_info & coe::value_info::kDefault;
  if (response.value_info != 0) {
    response.default_value = found->initial;
    response.default_value.resize((found->bits() + 7) / 8);
  }
  const bool count = request.sub_index == 0 && dictionary_.sub_indices(request.index).back() != 0;
  response.name = count ? "SubIndex 000" : found->name;
  return response;
}

}  // namespace syncline::sim
