// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "protocol/diagnosis_message_type.h"
#include "support/result.h"

namespace syncline {

/// One message of the diagnosis history, object 0x10F3 from sub-index 6 on (ETG.1020, 16).
struct DiagnosisMessage {
  using Type = DiagnosisMessageType;
  struct Parameter {
    std::uint16_t flags = 0;  // bits 15..12: 0 a basic type (bits 11..0), 1 octets, 2 and 3 text; else its size
    std::vector<std::uint8_t> data;
    bool operator==(const Parameter&) const = default;
  };

  std::uint32_t code = 0;  // diag code: 0xE000..: manufacturer specific in the upper word
  Type type = Type::kInfo;
  std::uint16_t text_id = 0;     // of the ESI's DiagMessages, 0: none
  std::uint64_t time_stamp = 0;  // DC system time, or ns since power-on; 0: none
  std::vector<Parameter> parameters;

  bool operator==(const DiagnosisMessage&) const = default;
  [[nodiscard]] std::vector<std::uint8_t> encode() const;
  /// kMalformedData when the message is shorter than it says.
  [[nodiscard]] static Result<DiagnosisMessage> decode(std::span<const std::uint8_t> bytes);
};

/// Places in 0x10F3.
namespace diagnosis_history {
inline constexpr std::uint16_t kIndex = 0x10F3;
inline constexpr std::uint8_t kMaximum = 1, kNewest = 2, kNewestAcknowledged = 3, kNewAvailable = 4, kFlags = 5;
inline constexpr std::uint8_t kFirstMessage = 6;
// Bits of kFlags.
inline constexpr std::uint16_t kSendEmergency = 0x01, kNoInfo = 0x02, kNoWarning = 0x04, kNoError = 0x08,
                               kAcknowledgeMode = 0x10, kOverwritten = 0x20;
}  // namespace diagnosis_history

}  // namespace syncline
