// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/diagnosis_history_reader.h"

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

Result<DiagnosisHistory> read_diagnosis_history(MailboxClient& mailbox, std::uint8_t after) {
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
  if (*last < place::kFirstMessage) return history;
  const unsigned places = *last - place::kFirstMessage + 1U;
  const auto place_of = [&](unsigned sub_index) { return sub_index - place::kFirstMessage; };
  const auto in_ring = [&](std::uint8_t sub_index) { return sub_index >= place::kFirstMessage && sub_index <= *last; };
  // The ring begins behind the newest message, as far as it is filled.
  const unsigned newest_place = in_ring(*newest) ? place_of(*newest) : places - 1;
  const unsigned first = in_ring(after) ? (place_of(after) + 1) % places : (newest_place + 1) % places;
  unsigned count = (newest_place + places - first) % places + 1;
  if (in_ring(after) && after == *newest) count = 0;
  for (unsigned step = 0; step < count; ++step) {
    const auto sub_index = static_cast<std::uint8_t>(place::kFirstMessage + (first + step) % places);
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
