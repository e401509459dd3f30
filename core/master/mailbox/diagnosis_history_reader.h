// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "protocol/diagnosis_message.h"

namespace syncline {

class MailboxClient;

/// A slave's diagnosis history, object 0x10F3. Changes nothing in the slave: messages stay unacknowledged.
struct DiagnosisHistory {
  struct Entry {
    std::uint8_t sub_index = 0;
    DiagnosisMessage message;
  };
  std::uint8_t newest = 0;  // sub-index of the newest message, 0: none
  bool new_available = false;
  std::vector<Entry> messages;  // oldest first
  std::size_t unreadable = 0;   // messages shorter than they say
};

/// Only what came `after` the message of that sub-index; 0: all. kSdoAbort when the slave has no history, else as
/// CoeClient::upload().
[[nodiscard]] Result<DiagnosisHistory> read_diagnosis_history(MailboxClient& mailbox, std::uint8_t after = 0);

}  // namespace syncline
