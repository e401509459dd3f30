// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/family_status_reader.h"

#include "config/identity.h"
#include "families/device_family.h"
#include "master/mailbox/coe_client.h"

namespace syncline {
namespace {

constexpr std::uint8_t kMostNodes = 127;  // CANopen

}  // namespace

Result<FamilyStatus> read_family_status(MailboxClient& mailbox, const Identity& identity) {
  FamilyStatus result;
  result.family = families::find(identity);
  if (result.family == nullptr) return result;
  CoeClient client(mailbox);
  if (const auto& status = result.family->status) {
    const auto value = client.upload_number(status->object);
    if (!value) return tl::unexpected(value.error());
    result.status = *value;
    if (*value) result.lines = families::status_lines(*status, **value);
  }
  if (const auto& gateway = result.family->gateway) {
    const auto count = client.upload_number({gateway->node_states, 0});
    if (!count) return tl::unexpected(count.error());
    for (std::uint8_t node = 1; node <= kMostNodes && node <= count->value_or(0); ++node) {
      const auto state = client.upload_number({gateway->node_states, node});
      if (!state) return tl::unexpected(state.error());
      result.node_states.push_back(static_cast<std::uint8_t>(state->value_or(0)));
    }
  }
  return result;
}

}  // namespace syncline
