// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/sync_object_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/device_description.h"
#include "master/mailbox/coe_client.h"
#include "master/mailbox/sdo_info_client.h"
#include "master/mailbox/sm2_counter_profile.h"
#include "protocol/coe.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

struct Known {
  std::uint8_t sub_index;
  SyncValue meaning;
  std::string_view name;
};

/// Names and places of ETG.1020; the two counters stand where most devices have them.
constexpr std::array kKnown{
    Known{0x01, SyncValue::kType, "Synchronization type"},
    Known{0x02, SyncValue::kCycleTime, "Cycle time"},
    Known{0x03, SyncValue::kShiftTime, "Shift time"},
    Known{0x04, SyncValue::kSupportedTypes, "Synchronization types supported"},
    Known{0x05, SyncValue::kMinimumCycleTime, "Minimum cycle time"},
    Known{0x06, SyncValue::kCalcAndCopyTime, "Calc and copy time"},
    Known{0x07, SyncValue::kMinimumDelay, "Minimum delay time"},
    Known{0x08, SyncValue::kGetCycleTime, "Get cycle time"},
    Known{0x09, SyncValue::kMaximumDelay, "Maximum delay time"},
    Known{0x0A, SyncValue::kSync0CycleTime, "Sync0 cycle time"},
    Known{kSm2MissedSubIndex, SyncValue::kMissed, "SM event missed (ETG.1020) or cycle exceeded (old layout)"},
    Known{kSm2MissedSubIndexOldLayout, SyncValue::kCycleExceeded,
          "Cycle exceeded (ETG.1020) or SM event missed (old layout)"},
    Known{0x0D, SyncValue::kShiftTooShort, "Shift too short counter"},
    Known{0x0E, SyncValue::kToggleFailed, "RxPDO toggle failed counter"},
    Known{0x0F, SyncValue::kMinimumCycleDistance, "Minimum cycle distance"},
    Known{0x10, SyncValue::kMaximumCycleDistance, "Maximum cycle distance"},
    Known{0x11, SyncValue::kMinimumSyncDistance, "Minimum SM SYNC distance"},
    Known{0x12, SyncValue::kMaximumSyncDistance, "Maximum SM SYNC distance"},
    Known{0x20, SyncValue::kSyncError, "Sync error"},
};

bool not_told(const Error& error) {
  return error.code == ErrorCode::kSdoAbort || error.code == ErrorCode::kMailboxProtocol;
}

/// Asks for names until the slave shows that it has no SDO information.
class NameReader {
 public:
  explicit NameReader(MailboxClient& mailbox) : client_(mailbox) {}

  Result<std::string> entry(std::uint16_t index, std::uint8_t sub_index) {
    if (!available_) return std::string{};
    return name_of(client_.entry(index, sub_index));
  }
  Result<std::string> object(std::uint16_t index) {
    if (!available_) return std::string{};
    return name_of(client_.object(index));
  }

 private:
  template <class Description>
  Result<std::string> name_of(const Result<Description>& description) {
    if (description) return description->name;
    if (!not_told(description.error())) return tl::unexpected(description.error());
    available_ = description.error().code == ErrorCode::kSdoAbort;
    return std::string{};
  }
  SdoInfoClient client_;
  bool available_ = true;
};

SyncParameters::Entry* find(SyncParameters& parameters, std::uint8_t sub_index) {
  const auto found = std::ranges::find(parameters.entries, sub_index, &SyncParameters::Entry::sub_index);
  return found == parameters.entries.end() ? nullptr : &*found;
}

/// Which of the two counters counts what: by the slave's words, else by what is known of its device.
void resolve_counters(SyncParameters& parameters, const Identity& identity) {
  auto* first = find(parameters, kSm2MissedSubIndex);
  auto* second = find(parameters, kSm2MissedSubIndexOldLayout);
  const auto name = [](const SyncParameters::Entry* entry) {
    return entry != nullptr ? std::string_view(entry->name) : "";
  };
  auto missed = sm2_missed_sub_index(name(first), name(second));
  parameters.counter_source = CounterSource::kObjectName;
  if (missed == 0) {
    parameters.counter_source = CounterSource::kDeviceProfile;
    missed = known_sm2_missed_sub_index(identity).value_or(0);
  }
  if (missed == 0) parameters.counter_source = CounterSource::kUnknown;
  for (auto* entry : {first, second}) {
    if (entry == nullptr) continue;
    entry->meaning = missed == 0                  ? SyncValue::kMissedOrExceeded
                     : entry->sub_index == missed ? SyncValue::kMissed
                                                  : SyncValue::kCycleExceeded;
  }
}

Result<Identity> read_identity(CoeClient client) {
  Identity identity;
  std::uint8_t sub_index = 0;
  for (auto* value : {&identity.vendor_id, &identity.product_code, &identity.revision_no}) {
    const auto read = client.upload_number({0x1018, ++sub_index});
    if (!read) return tl::unexpected(read.error());
    *value = read->value_or(0);
  }
  return identity;
}

/// Empty when the slave does not have the object.
Result<std::optional<SyncParameters>> read_object(MailboxClient& mailbox, NameReader& names, std::uint16_t index,
                                                  const Identity& identity) {
  CoeClient client(mailbox);
  const auto count = client.upload_number({index, 0});
  if (!count) return tl::unexpected(count.error());
  if (!*count) return std::optional<SyncParameters>{};
  SyncParameters parameters;
  parameters.index = index;
  const auto name = names.object(index);
  if (!name) return tl::unexpected(name.error());
  parameters.name = *name;
  if (parameters.name.empty())
    parameters.name = index == kSyncManager2Parameter ? "SM output parameter" : "SM input parameter";
  for (const auto& known : kKnown) {
    if (known.sub_index > **count) break;
    const auto value = client.upload_number({index, known.sub_index});
    if (!value) return tl::unexpected(value.error());
    if (!*value) continue;
    const auto entry_name = names.entry(index, known.sub_index);
    if (!entry_name) return tl::unexpected(entry_name.error());
    parameters.entries.push_back({known.sub_index, known.meaning, *entry_name, **value});
  }
  resolve_counters(parameters, identity);
  for (auto& entry : parameters.entries) {
    if (!entry.name.empty()) continue;
    const auto known = std::ranges::find(kKnown, entry.sub_index, &Known::sub_index);
    entry.name = known->name;
    if (entry.meaning == SyncValue::kMissed) entry.name = "SM event missed counter";
    if (entry.meaning == SyncValue::kCycleExceeded) entry.name = "Cycle exceeded counter";
  }
  return std::optional(std::move(parameters));
}

}  // namespace

std::optional<std::uint32_t> SyncParameters::value(SyncValue meaning) const {
  const auto found = std::ranges::find(entries, meaning, &Entry::meaning);
  return found == entries.end() ? std::nullopt : std::optional(found->value);
}

Result<Identity> read_identity_object(MailboxClient& mailbox) { return read_identity(CoeClient(mailbox)); }

Result<std::vector<SyncParameters>> read_sync_objects(MailboxClient& mailbox) {
  const auto identity = read_identity_object(mailbox);
  if (!identity) return tl::unexpected(identity.error());
  NameReader names(mailbox);
  std::vector<SyncParameters> objects;
  for (const auto index : {kSyncManager2Parameter, kSyncManager3Parameter}) {
    auto object = read_object(mailbox, names, index, *identity);
    if (!object) return tl::unexpected(object.error());
    if (*object) objects.push_back(std::move(**object));
  }
  return objects;
}

std::string sync_type_text(std::uint32_t type) {
  switch (type) {
    case 0x00:
      return "free run";
    case 0x01:
      return "synchronous with its SM event";
    case 0x02:
      return "DC, SYNC0";
    case 0x03:
      return "DC, SYNC1";
    case 0x22:
      return "synchronous with the SM2 event";
    default:
      return "unknown";
  }
}

std::string supported_types_text(std::uint32_t bits) {
  constexpr std::array<std::pair<std::uint32_t, std::string_view>, 7> kBits{{{0x0001, "free run"},
                                                                             {0x0002, "SM event"},
                                                                             {0x0004, "SYNC0"},
                                                                             {0x0008, "SYNC1"},
                                                                             {0x0010, "shift by local timer"},
                                                                             {0x0020, "shift by SYNC1"},
                                                                             {0x4000, "measures its times"}}};
  std::string text;
  for (const auto& [bit, name] : kBits) {
    if ((bits & bit) == 0) continue;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
    bits &= ~bit;
  }
  if (bits != 0) text += fmt::format("{}0x{:04X}", text.empty() ? "" : ", ", bits);
  return text.empty() ? "none" : text;
}

std::string_view sync_value_key(SyncValue value) {
  switch (value) {
    case SyncValue::kOther:
      break;
    case SyncValue::kType:
      return "type";
    case SyncValue::kCycleTime:
      return "cycle_time";
    case SyncValue::kShiftTime:
      return "shift_time";
    case SyncValue::kSupportedTypes:
      return "supported_types";
    case SyncValue::kMinimumCycleTime:
      return "minimum_cycle_time";
    case SyncValue::kCalcAndCopyTime:
      return "calc_and_copy_time";
    case SyncValue::kMinimumDelay:
      return "minimum_delay";
    case SyncValue::kGetCycleTime:
      return "get_cycle_time";
    case SyncValue::kMaximumDelay:
      return "maximum_delay";
    case SyncValue::kSync0CycleTime:
      return "sync0_cycle_time";
    case SyncValue::kMissed:
      return "sm_event_missed";
    case SyncValue::kCycleExceeded:
      return "cycle_exceeded";
    case SyncValue::kMissedOrExceeded:
      return "missed_or_exceeded";
    case SyncValue::kShiftTooShort:
      return "shift_too_short";
    case SyncValue::kToggleFailed:
      return "toggle_failed";
    case SyncValue::kMinimumCycleDistance:
      return "minimum_cycle_distance";
    case SyncValue::kMaximumCycleDistance:
      return "maximum_cycle_distance";
    case SyncValue::kMinimumSyncDistance:
      return "minimum_sm_sync_distance";
    case SyncValue::kMaximumSyncDistance:
      return "maximum_sm_sync_distance";
    case SyncValue::kSyncError:
      return "sync_error";
  }
  return "other";
}

bool is_sync_time(SyncValue value) {
  switch (value) {
    case SyncValue::kCycleTime:
    case SyncValue::kShiftTime:
    case SyncValue::kMinimumCycleTime:
    case SyncValue::kCalcAndCopyTime:
    case SyncValue::kMinimumDelay:
    case SyncValue::kMaximumDelay:
    case SyncValue::kSync0CycleTime:
    case SyncValue::kMinimumCycleDistance:
    case SyncValue::kMaximumCycleDistance:
    case SyncValue::kMinimumSyncDistance:
    case SyncValue::kMaximumSyncDistance:
      return true;
    default:
      return false;
  }
}

}  // namespace syncline
