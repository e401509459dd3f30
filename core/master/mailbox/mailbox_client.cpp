// SPDX-License-Identifier: Apache-2.0
#include "master/mailbox/mailbox_client.h"

#include "master/exchange/mailbox_handshake.h"
#include "master/mailbox/fetch_work.h"
#include "master/mailbox/mailbox_transfer.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"

namespace syncline {

Status MailboxClient::collect() {
  for (int messages = 0; messages < kMostUnasked; ++messages) {
    const auto status = bus_.read<std::uint8_t>(port().station_address, kSm1Status, port().name);
    if (!status) return tl::unexpected(status.error());
    if ((*status & SyncManager::kStatusMailboxFull) == 0) return {};
    FetchWork fetch(mailbox_);
    if (auto done = run(fetch); !done) return done;
  }
  return {};
}

}  // namespace syncline
