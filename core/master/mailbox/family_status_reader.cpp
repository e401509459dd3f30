// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/family_status_reader.h"

#include "master/mailbox/coe_client.h"

namespace syncline {
namespace {

constexpr std::uint8_t kMostNodes = 127;  // CANopen

/// Nothing when the slave does not have the entry.
Result<std::optional<std::uint32_t>> read_value(CoeClient& client, coe::ObjectAddress object) {
  const auto bytes = client.upload(object);
  if (!bytes && bytes.error().code == ErrorCode::kSdoAbort) return std::optional<std::uint32_t>{};
  if (!bytes) return tl::unexpected(bytes.error());
  if (bytes->empty() || bytes->size() > 4) return std::optional<std::uint32_t>{};
  std::uint32_t value = 0;
  for (std::size_t i = bytes->size(); i-- > 0;) value = value << 8 | (*bytes)[i];
  return std::optional(value);
}

}  // namespace

Result<FamilyStatus> read_family_status(MailboxClient& mailbox, const Identity& identity) {
  FamilyStatus result;
  result.family = families::find(identity);
  if (result.family == nullptr) return result;
  CoeClient client(mailbox);
  if (const auto& status = result.family->status) {
    const auto value = read_value(client, status->object);
    if (!value) return tl::unexpected(value.error());
    result.status = *value;
    if (*value) result.lines = families::status_lines(*status, **value);
  }
  if (const auto& gateway = result.family->gateway) {
    const auto count = read_value(client, {gateway->node_states, 0});
    if (!count) return tl::unexpected(count.error());
    for (std::uint8_t node = 1; node <= kMostNodes && node <= count->value_or(0); ++node) {
      const auto state = read_value(client, {gateway->node_states, node});
      if (!state) return tl::unexpected(state.error());
      result.node_states.push_back(static_cast<std::uint8_t>(state->value_or(0)));
    }
  }
  return result;
}

}  // namespace syncline
