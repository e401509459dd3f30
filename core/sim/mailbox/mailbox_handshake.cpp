// SPDX-License-Identifier: Apache-2.0
#include "sim/mailbox/mailbox_handshake.h"

#include <algorithm>
#include <utility>

namespace syncline::sim {

void MailboxHandshake::serve(bool in_preop) {
  const auto in = esc_.sync_manager(0);
  const auto out = esc_.sync_manager(1);
  if ((in.status & SyncManager::kStatusMailboxFull) != 0) {
    server_.receive(std::as_const(esc_).sync_manager_area(0), out.length, in_preop);
    esc_.set_mailbox_full(0, false);
  }
  if (!out.enabled()) return;
  const bool full = (out.status & SyncManager::kStatusMailboxFull) != 0;
  if (esc_.repeat_requested(1)) {
    const auto& again = server_.repeat(full);
    esc_.acknowledge_repeat(1);
    if (!again.empty()) return load(again);
    // Nothing to repeat, as where the mailbox was set up anew and its toggle is not that of the acknowledged
    // repetition: what waits is not kept back for it.
  }
  if (!server_.waiting() || full) return;
  if (const auto bytes = server_.next(out.length)) load(*bytes);
}

void MailboxHandshake::load(std::span<const std::uint8_t> bytes) {
  const auto area = esc_.sync_manager_area(1);
  std::ranges::copy(bytes.first(std::min(bytes.size(), area.size())), area.begin());
  esc_.set_mailbox_full(1, true);
}

}  // namespace syncline::sim
