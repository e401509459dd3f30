// SPDX-License-Identifier: Apache-2.0
#include "master/startup/sm2_counter_lookup.h"

#include <map>
#include <tuple>

#include "channels/snapshot.h"
#include "config/network_config.h"
#include "master/cyclic/sm2_reader.h"
#include "master/exchange/slave_mailbox.h"
#include "master/mailbox/mailbox_client.h"
#include "master/mailbox/sdo_info_client.h"
#include "master/mailbox/sm2_counter_profile.h"

namespace syncline {
namespace {

/// A device without the service answers at once; one that says nothing must not hold the bring-up.
constexpr Nanoseconds kLookupPatience = 200 * kMillisecond;

bool ends_the_bring_up(const Error& error) {
  return error.code == ErrorCode::kCancelled || error.code == ErrorCode::kNoResponse ||
         error.code == ErrorCode::kLinkIo || error.code == ErrorCode::kLinkDown;
}

/// 0 when the slave does not say.
Result<std::uint8_t> ask(Bus& bus, SlaveMailbox& shared) {
  MailboxClient mailbox(bus, shared);
  mailbox.set_response_timeout(kLookupPatience);
  SdoInfoClient information(mailbox);
  std::string names[2];
  const std::uint8_t places[] = {kSm2MissedSubIndex, kSm2MissedSubIndexOldLayout};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto entry = information.entry(kSyncManager2Parameter, places[i]);
    if (entry) {
      names[i] = entry->name;
    } else if (ends_the_bring_up(entry.error())) {
      return tl::unexpected(entry.error());
    } else if (entry.error().code != ErrorCode::kSdoAbort) {
      return std::uint8_t{0};  // no SDO information here: no use asking for the other one
    }
  }
  return sm2_missed_sub_index(names[0], names[1]);
}

}  // namespace

Status find_sm2_counters(Bus& bus, const NetworkConfig& network, const Snapshot& snapshot,
                         std::span<SlaveMailbox> mailboxes, Sm2Reader& reader) {
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint8_t> kinds;
  for (const auto slave : reader.slaves()) {
    if (!snapshot.slaves[slave].present) continue;
    const auto& config = network.slaves[slave];
    const auto [kind, unknown] = kinds.try_emplace(
        {config.identity.vendor_id, config.identity.product_code, config.identity.revision_no}, std::uint8_t{0});
    if (unknown) {
      const auto place = ask(bus, mailboxes[slave]);
      if (!place) return tl::unexpected(place.error());
      kind->second = *place;
    }
    if (kind->second != 0) reader.set_sub_index(slave, kind->second);
  }
  return {};
}

}  // namespace syncline
