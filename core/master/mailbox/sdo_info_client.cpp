// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/sdo_info_client.h"

#include "master/mailbox/sdo_work.h"

namespace syncline {
namespace {

/// 65536 indexes, and far more than any description.
constexpr std::size_t kLargestAnswer = 2 + 2 * 0x1'0000;

}  // namespace

template <class Expected>
Result<Expected> SdoInfoClient::ask_for(const coe::InformationRequest& request) {
  std::vector<std::uint8_t> data;
  SdoWork work(mailbox_.mailbox());
  work.ask(request, data, kLargestAnswer);
  if (auto status = mailbox_.run(work); !status) return tl::unexpected(status.error());
  auto response = coe::decode_information_response(coe::response_opcode(request), data);
  if (!response) return fail(ErrorCode::kMailboxProtocol, work.subject(), response.error().detail);
  return std::get<Expected>(std::move(*response));
}

Result<std::vector<std::uint16_t>> SdoInfoClient::object_list(coe::ObjectListType list) {
  auto found = ask_for<coe::ObjectList>(coe::ObjectListRequest{list});
  if (!found) return tl::unexpected(found.error());
  return std::move(found->indices);
}

Result<coe::ObjectDescription> SdoInfoClient::object(std::uint16_t index) {
  return ask_for<coe::ObjectDescription>(coe::ObjectDescriptionRequest{index});
}

Result<coe::EntryDescription> SdoInfoClient::entry(std::uint16_t index, std::uint8_t sub_index,
                                                   std::uint8_t value_info) {
  return ask_for<coe::EntryDescription>(coe::EntryDescriptionRequest{index, sub_index, value_info});
}

}  // namespace syncline
