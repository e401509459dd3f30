// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "protocol/diagnosis_message.h"

/// A whole diagnosis history as it is read out of a slave's 0x10F3 (ETG.1020, 16), entry by entry.
namespace syncline {

/// What stands in front of the messages.
struct DiagnosisHeader {
  std::uint8_t last = 0;                 // sub-index 0: of the last message that there is room for
  std::uint8_t maximum = 0;              // 01: messages
  std::uint8_t newest = 0;               // 02: sub-index, 0: none
  std::uint8_t newest_acknowledged = 0;  // 03: sub-index, 0: none
  bool new_available = false;            // 04
  std::optional<std::uint16_t> flags{};  // 05: bits of diagnosis_history; empty: the slave has no such entry
  bool operator==(const DiagnosisHeader&) const = default;

  /// Takes the bytes of entry `sub_index` (0..5); false when they are too few for it, or it is none of the header.
  [[nodiscard]] bool take(std::uint8_t sub_index, std::span<const std::uint8_t> bytes);
  /// There is room for messages, and 02 names one of them.
  [[nodiscard]] bool in_ring(std::uint8_t sub_index) const;
  /// Somebody has acknowledged the message of that sub-index. Unknown counts as not: a mark at the newest message while
  /// there are new ones has been run over, and says nothing.
  [[nodiscard]] bool acknowledged(std::uint8_t sub_index) const;
};

/// Sub-indices that may hold a message, oldest first, each once; those that nobody has written yet among them. `after`:
/// only what came behind the message of that sub-index, if it is one; 0: all.
[[nodiscard]] std::vector<std::uint8_t> message_places(const DiagnosisHeader& header, std::uint8_t after = 0);

/// No message has been there yet, or it was cleared.
[[nodiscard]] bool is_empty_message(std::span<const std::uint8_t> bytes);

struct DiagnosisEntry {
  std::uint8_t sub_index = 0;
  std::vector<std::uint8_t> bytes{};          // as read
  std::optional<DiagnosisMessage> message{};  // nothing: it is shorter than it says
  bool operator==(const DiagnosisEntry&) const = default;
};
/// Entries that hold something, oldest first, whatever order they were read in.
struct DiagnosisLog {
  DiagnosisHeader header;
  std::vector<DiagnosisEntry> entries;
  bool operator==(const DiagnosisLog&) const = default;
};
[[nodiscard]] DiagnosisLog diagnosis_log(
    const DiagnosisHeader& header, const std::vector<std::pair<std::uint8_t, std::vector<std::uint8_t>>>& messages);

}  // namespace syncline
