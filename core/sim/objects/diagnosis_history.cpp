// SPDX-License-Identifier: Apache-2.0
#include "sim/objects/diagnosis_history.h"

#include <algorithm>

#include "protocol/diagnosis_message.h"
#include "sim/objects/object_dictionary.h"

namespace syncline::sim {
namespace {

namespace dh = diagnosis_history;

constexpr std::uint8_t kLastMessage = dh::kFirstMessage + DiagnosisHistory::kMessages - 1;

}  // namespace

DiagnosisHistory::DiagnosisHistory(ObjectDictionary& dictionary) : dictionary_(dictionary) {}

void DiagnosisHistory::enable() {
  enabled_ = true;
  auto& d = dictionary_;
  d.set_object_name(dh::kIndex, "Diagnosis history");
  d.add<std::uint8_t>(dh::kIndex, 0, "Number of entries", kLastMessage);
  d.add<std::uint8_t>(dh::kIndex, dh::kMaximum, "Maximum messages", kMessages);
  d.add<std::uint8_t>(dh::kIndex, dh::kNewest, "Newest message", 0);
  auto& acknowledged = d.add<std::uint8_t>(dh::kIndex, dh::kNewestAcknowledged, "Newest acknowledged message", 0, true);
  acknowledged.on_write = [this](std::span<const std::uint8_t> data) { return acknowledge(data[0]); };
  d.add<std::uint8_t>(dh::kIndex, dh::kNewAvailable, "New messages available", 0).data_type = 0x01;
  d.add<std::uint16_t>(dh::kIndex, dh::kFlags, "Flags", 0, true);
  for (std::uint8_t sub = dh::kFirstMessage; sub <= kLastMessage; ++sub) {
    d.add(dh::kIndex, sub, "Diagnosis message", DiagnosisMessage{}.encode());
  }
}

std::uint8_t DiagnosisHistory::behind(std::uint8_t sub_index) {
  return sub_index < dh::kFirstMessage || sub_index == kLastMessage ? dh::kFirstMessage
                                                                    : static_cast<std::uint8_t>(sub_index + 1);
}

std::uint16_t DiagnosisHistory::flags() { return dictionary_.get<std::uint16_t>(dh::kIndex, dh::kFlags); }

void DiagnosisHistory::add(const DiagnosisMessage& message) {
  if (!enabled_) return;
  constexpr std::uint16_t kDisabled[] = {dh::kNoInfo, dh::kNoWarning, dh::kNoError};
  if ((flags() & kDisabled[static_cast<unsigned>(message.type)]) != 0) return;
  if (unread_ == kMessages) {  // full of what nobody has seen
    dictionary_.set<std::uint16_t>(dh::kIndex, dh::kFlags, flags() | dh::kOverwritten);
    if ((flags() & dh::kAcknowledgeMode) != 0) return;
  } else {
    ++unread_;
  }
  const auto next = behind(dictionary_.get<std::uint8_t>(dh::kIndex, dh::kNewest));
  if (auto* entry = dictionary_.find(dh::kIndex, next)) entry->value = message.encode();
  dictionary_.set<std::uint8_t>(dh::kIndex, dh::kNewest, next);
  dictionary_.set<std::uint8_t>(dh::kIndex, dh::kNewAvailable, 1);
}

void DiagnosisHistory::clear() {
  unread_ = 0;
  dictionary_.set<std::uint8_t>(dh::kIndex, dh::kNewest, 0);
  for (std::uint8_t sub = dh::kFirstMessage; sub <= kLastMessage; ++sub) {
    if (auto* entry = dictionary_.find(dh::kIndex, sub)) entry->value = DiagnosisMessage{}.encode();
  }
}

std::uint32_t DiagnosisHistory::acknowledge(std::uint8_t sub_index) {
  const auto newest = dictionary_.get<std::uint8_t>(dh::kIndex, dh::kNewest);
  if (sub_index == 0) {
    clear();
  } else if (sub_index < dh::kFirstMessage || sub_index > kLastMessage || newest == 0) {
    return abort::kRange;
  } else {
    const unsigned since = (newest + kMessages - sub_index) % kMessages;
    unread_ = std::min(unread_, since);
  }
  // What was lost is known by now.
  dictionary_.set<std::uint16_t>(dh::kIndex, dh::kFlags, static_cast<std::uint16_t>(flags() & ~dh::kOverwritten));
  dictionary_.set<std::uint8_t>(dh::kIndex, dh::kNewAvailable, unread_ > 0 ? 1 : 0);
  return abort::kNone;
}

}  // namespace syncline::sim
