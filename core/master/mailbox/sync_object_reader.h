// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/registers.h"
#include "support/result.h"

namespace syncline {

struct Identity;
class MailboxClient;

/// What a value of 0x1C32/0x1C33 means (ETG.1020), wherever the slave keeps it.
enum class SyncValue : std::uint8_t {
  kOther,
  kType,
  kCycleTime,
  kShiftTime,
  kSupportedTypes,
  kMinimumCycleTime,
  kCalcAndCopyTime,
  kMinimumDelay,
  kGetCycleTime,
  kMaximumDelay,
  kSync0CycleTime,
  kMissed,
  kCycleExceeded,
  kMissedOrExceeded,
  kShiftTooShort,
  kToggleFailed,
  kMinimumCycleDistance,
  kMaximumCycleDistance,
  kMinimumSyncDistance,
  kMaximumSyncDistance,
  kSyncError,
};

/// How it is known which of :0B and :0C counts missed SM events.
enum class CounterSource : std::uint8_t {
  kObjectName,     // the slave calls it so
  kDeviceProfile,  // the slave says nothing, its device is known
  kUnknown,        // both are shown
};

/// Synchronisation parameters of one SyncManager, those that the slave has.
struct SyncParameters {
  struct Entry {
    std::uint8_t sub_index = 0;
    SyncValue meaning = SyncValue::kOther;
    std::string name;         // in the slave's words, else those of ETG.1020
    std::uint32_t value = 0;  // times in ns
  };
  std::uint16_t index = 0;  // 0x1C32 outputs, 0x1C33 inputs
  std::string name;
  std::vector<Entry> entries;  // ascending
  CounterSource counter_source = CounterSource::kUnknown;

  [[nodiscard]] std::optional<std::uint32_t> value(SyncValue meaning) const;
};

/// Reads 0x1C32 and 0x1C33; an object that the slave does not have is left out. Changes nothing in the slave.
/// kMailboxTimeout, kMailboxProtocol and errors of the bus; never kSdoAbort.
[[nodiscard]] Result<std::vector<SyncParameters>> read_sync_objects(MailboxClient& mailbox);

/// Vendor, product and revision of 0x1018; 0 where the slave does not say. Errors as read_sync_objects().
[[nodiscard]] Result<Identity> read_identity_object(MailboxClient& mailbox);

/// Words for values of sub-index 1 and bits of sub-index 4.
[[nodiscard]] std::string sync_type_text(std::uint32_t type);
[[nodiscard]] std::string supported_types_text(std::uint32_t bits);
/// A key for files: "cycle_time", "sm_event_missed".
[[nodiscard]] std::string_view sync_value_key(SyncValue value);
/// The value is a time in ns.
[[nodiscard]] bool is_sync_time(SyncValue value);

}  // namespace syncline
