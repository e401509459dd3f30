// SPDX-License-Identifier: Apache-2.0
#include "master/diagnosis_history_reader.h"

#include <algorithm>

namespace syncline {
namespace {

namespace place = diagnosis_history;

Result<std::uint8_t> read_byte(CoeClient& client, std::uint8_t sub_index) {
  const auto bytes = client.upload({place::kIndex, sub_index});
  if (!bytes) return tl::unexpected(bytes.error());
  return bytes->empty() ? std::uint8_t{0} : bytes->front();
}

}  // namespace

Result<DiagnosisHistory> read_diagnosis_history(MailboxClient& mailbox) {
  CoeClient client(mailbox);
  DiagnosisHistory history;
  const auto last = read_byte(client, 0);
  if (!last) return tl::unexpected(last.error());
  const auto newest = read_byte(client, place::kNewest);
  if (!newest) return tl::unexpected(newest.error());
  const auto available = read_byte(client, place::kNewAvailable);
  if (!available) return tl::unexpected(available.error());
  history.newest = *newest;
  history.new_available = *available != 0;
  // The ring begins behind the newest message, as far as it is filled.
  for (unsigned step = 1; *last >= place::kFirstMessage && step <= *last - place::kFirstMessage + 1U; ++step) {
    const unsigned places = *last - place::kFirstMessage + 1U;
    const unsigned start = *newest >= place::kFirstMessage && *newest <= *last ? *newest - place::kFirstMessage : places - 1;
    const auto sub_index = static_cast<std::uint8_t>(place::kFirstMessage + (start + step) % places);
    const auto bytes = client.upload({place::kIndex, sub_index});
    if (!bytes && bytes.error().code != ErrorCode::kSdoAbort) return tl::unexpected(bytes.error());
    if (!bytes || std::ranges::all_of(*bytes, [](std::uint8_t byte) { return byte == 0; })) continue;  // not used yet
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
