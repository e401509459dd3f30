// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/diagnosis_history_reader.h"

#include <span>

#include "master/mailbox/coe_client.h"
#include "protocol/coe.h"
#include "protocol/diagnosis_log.h"

namespace syncline {
namespace {

namespace place = diagnosis_history;

Result<std::uint8_t> read_byte(CoeClient& client, std::uint8_t sub_index) {
  const auto bytes = client.upload({place::kIndex, sub_index});
  if (!bytes) return tl::unexpected(bytes.error());
  return bytes->empty() ? std::uint8_t{0} : bytes->front();
}

}  // namespace

Result<DiagnosisHistory> read_diagnosis_history(MailboxClient& mailbox, std::uint8_t after) {
  CoeClient client(mailbox);
  DiagnosisHistory history;
  DiagnosisHeader header;
  for (const std::uint8_t sub_index : {std::uint8_t{0}, place::kNewest, place::kNewAvailable}) {
    const auto value = read_byte(client, sub_index);
    if (!value) return tl::unexpected(value.error());
    (void)header.take(sub_index, std::span(&*value, 1));
  }
  history.newest = header.newest;
  history.new_available = header.new_available;
  for (const auto sub_index : message_places(header, after)) {
    const auto bytes = client.upload({place::kIndex, sub_index});
    if (!bytes && bytes.error().code != ErrorCode::kSdoAbort) return tl::unexpected(bytes.error());
    if (!bytes || is_empty_message(*bytes)) continue;  // not used yet
    auto message = DiagnosisMessage::decode(*bytes);
    if (message) {
      history.messages.push_back({sub_index, std::move(*message)});
    } else {
      ++history.unreadable;
    }
  }
  return history;
}

}  // namespace syncline
