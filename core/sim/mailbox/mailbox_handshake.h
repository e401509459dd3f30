// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "sim/esc/esc.h"
#include "sim/mailbox/mailbox_server.h"

namespace syncline::sim {

/// Carries messages between the mailbox SyncManagers of an ESC (0: from the master, 1: to it) and the server.
class MailboxHandshake {
 public:
  MailboxHandshake(Esc& esc, MailboxServer& server) : esc_(esc), server_(server) {}

  /// The firmware looks at both mailboxes: takes a request, loads an answer, repeats the last one where asked.
  void serve(bool in_preop);

 private:
  void load(std::span<const std::uint8_t> bytes);

  Esc& esc_;
  MailboxServer& server_;
};

}  // namespace syncline::sim
