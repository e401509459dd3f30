// SPDX-License-Identifier: Apache-2.0
#include "protocol/diagnosis_log.h"

#include <algorithm>

#include "support/byte_order.h"

namespace syncline {
namespace {

namespace of_history = diagnosis_history;

unsigned place_of(std::uint8_t sub_index) { return sub_index - of_history::kFirstMessage; }

unsigned room_of(const DiagnosisHeader& header) {
  return header.last < of_history::kFirstMessage ? 0U : place_of(header.last) + 1U;
}

}  // namespace

bool DiagnosisHeader::take(std::uint8_t sub_index, std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return false;
  switch (sub_index) {
    case 0:
      last = bytes[0];
      return true;
    case of_history::kMaximum:
      maximum = bytes[0];
      return true;
    case of_history::kNewest:
      newest = bytes[0];
      return true;
    case of_history::kNewestAcknowledged:
      newest_acknowledged = bytes[0];
      return true;
    case of_history::kNewAvailable:
      new_available = bytes[0] != 0;
      return true;
    case of_history::kFlags:
      if (bytes.size() < 2) return false;
      flags = load_le<std::uint16_t>(bytes);
      return true;
    default:
      return false;
  }
}

bool DiagnosisHeader::in_ring(std::uint8_t sub_index) const {
  return sub_index >= of_history::kFirstMessage && sub_index <= last;
}

bool DiagnosisHeader::acknowledged(std::uint8_t sub_index) const {
  if (!in_ring(sub_index)) return false;
  if (!new_available) return true;
  if (!in_ring(newest) || !in_ring(newest_acknowledged) || newest == newest_acknowledged) return false;
  // In overwrite mode what was lost was new, so that all that is left is newer than the mark.
  const auto has = [&](std::uint16_t bit) { return (flags.value_or(0) & bit) != 0; };
  if (has(of_history::kOverwritten) && !has(of_history::kAcknowledgeMode)) return false;
  const unsigned room = room_of(*this);
  const auto age = [&](std::uint8_t sub) { return (place_of(newest) + room - place_of(sub)) % room; };
  return age(sub_index) >= age(newest_acknowledged);
}

std::vector<std::uint8_t> message_places(const DiagnosisHeader& header, std::uint8_t after) {
  const unsigned room = room_of(header);
  std::vector<std::uint8_t> places;
  if (room == 0 || (header.in_ring(after) && after == header.newest)) return places;
  // The ring begins behind the newest message, as far as it is filled.
  const unsigned newest = header.in_ring(header.newest) ? place_of(header.newest) : room - 1;
  const unsigned first = ((header.in_ring(after) ? place_of(after) : newest) + 1) % room;
  const unsigned count = (newest + room - first) % room + 1;
  for (unsigned step = 0; step < count; ++step) {
    places.push_back(static_cast<std::uint8_t>(of_history::kFirstMessage + (first + step) % room));
  }
  return places;
}

bool is_empty_message(std::span<const std::uint8_t> bytes) {
  return std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; });
}

DiagnosisLog diagnosis_log(const DiagnosisHeader& header,
                           const std::vector<std::pair<std::uint8_t, std::vector<std::uint8_t>>>& messages) {
  DiagnosisLog log{header, {}};
  for (const auto place : message_places(header)) {
    const auto read = std::ranges::find(messages, place, [](const auto& one) { return one.first; });
    if (read == messages.end() || is_empty_message(read->second)) continue;
    DiagnosisEntry entry{place, read->second, {}};
    if (auto message = DiagnosisMessage::decode(entry.bytes)) entry.message = std::move(*message);
    log.entries.push_back(std::move(entry));
  }
  return log;
}

}  // namespace syncline
