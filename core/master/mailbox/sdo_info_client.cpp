// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/sdo_info_client.h"

#include <fmt/format.h>

namespace syncline {
namespace {

/// 65536 indexes, and far more than any description.
constexpr std::size_t kLargestAnswer = 2 + 2 * 0x1'0000;
constexpr int kMostStale = 16;

bool concerns(const coe::InformationResponse& response, const coe::InformationRequest& request) {
  if (const auto* object = std::get_if<coe::ObjectDescription>(&response)) {
    const auto* asked = std::get_if<coe::ObjectDescriptionRequest>(&request);
    return asked != nullptr && asked->index == object->index;
  }
  if (const auto* entry = std::get_if<coe::EntryDescription>(&response)) {
    const auto* asked = std::get_if<coe::EntryDescriptionRequest>(&request);
    return asked != nullptr && asked->index == entry->index && asked->sub_index == entry->sub_index;
  }
  return true;
}

}  // namespace

Result<coe::InformationResponse> SdoInfoClient::ask(const coe::InformationRequest& request, std::string subject) {
  const auto refuse = [&](std::string why) { return fail(ErrorCode::kMailboxProtocol, subject, std::move(why)); };
  std::vector<std::uint8_t> data;
  int left = -1;  // fragments after the last one, -1 before the first
  int stale = 0;
  auto bytes = mailbox_.ask(MailboxType::kCoe, coe::encode(request));
  while (bytes) {
    const auto fragment = coe::decode_information_fragment(*bytes);
    const bool other = !fragment || !coe::answers(fragment->opcode, request);
    if (other) {
      if (++stale > kMostStale) return refuse("only answers to other requests come");
      bytes = mailbox_.receive_instead(MailboxType::kCoe);
      continue;
    }
    if (left >= 0 && fragment->fragments_left + 1 != left) return refuse("its fragments do not follow each other");
    left = fragment->fragments_left;
    data.insert(data.end(), fragment->data.begin(), fragment->data.end());
    if (data.size() > kLargestAnswer) return refuse("its answer has no end");
    if (left == 0) {
      auto response = coe::decode_information_response(fragment->opcode, data);
      if (!response) return refuse(response.error().detail);
      if (concerns(*response, request)) return response;
      if (++stale > kMostStale) return refuse("only answers to other requests come");
      data.clear();
      left = -1;
      bytes = mailbox_.receive_instead(MailboxType::kCoe);
      continue;
    }
    bytes = mailbox_.receive(MailboxType::kCoe);
  }
  return tl::unexpected(bytes.error());
}

template <class Expected>
Result<Expected> SdoInfoClient::ask_for(const coe::InformationRequest& request, const std::string& subject) {
  auto response = ask(request, subject);
  if (!response) return tl::unexpected(response.error());
  if (auto* expected = std::get_if<Expected>(&*response)) return std::move(*expected);
  Error error{ErrorCode::kSdoAbort, subject};
  error.received = std::get<coe::InformationError>(*response).abort_code;
  return fail(std::move(error));
}

Result<std::vector<std::uint16_t>> SdoInfoClient::object_list(coe::ObjectListType list) {
  auto found = ask_for<coe::ObjectList>(coe::ObjectListRequest{list}, mailbox_.port().name + ", object list");
  if (!found) return tl::unexpected(found.error());
  return std::move(found->indices);
}

Result<coe::ObjectDescription> SdoInfoClient::object(std::uint16_t index) {
  return ask_for<coe::ObjectDescription>(coe::ObjectDescriptionRequest{index},
                                         fmt::format("{}, description of 0x{:04X}", mailbox_.port().name, index));
}

Result<coe::EntryDescription> SdoInfoClient::entry(std::uint16_t index, std::uint8_t sub_index,
                                                   std::uint8_t value_info) {
  return ask_for<coe::EntryDescription>(
      coe::EntryDescriptionRequest{index, sub_index, value_info},
      fmt::format("{}, description of 0x{:04X}:{:02X}", mailbox_.port().name, index, sub_index));
}

}  // namespace syncline
