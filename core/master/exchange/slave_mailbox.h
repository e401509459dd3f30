// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "master/exchange/mailbox_handshake.h"
#include "support/types.h"

namespace syncline::coe {
struct Emergency;
}  // namespace syncline::coe

namespace syncline {

/// One slave's mailbox as whoever talks to it shares it: where it is, how far both sides have counted, who is told of
/// emergencies, and whose turn it is. Outlives all who use it.
struct SlaveMailbox {
  MailboxPort port;
  std::uint8_t counter = 0;  // of the last request
  /// What the latest cyclic frames say about it; nothing where they do not say it, and when it has changed since.
  std::optional<bool> full{};
  MailboxHandshake::Receipt receipt{};
  /// Called in the thread that talks to the slave; may be empty.
  std::function<void(const coe::Emergency&, Nanoseconds now)> on_emergency{};
  bool taken = false;     // work of the running bus is under way in it
  bool wanted = false;    // a request from outside waits for it
  bool own_last = false;  // the work before was the master's own: a request comes next
  int reserved = 0;       // so many want it for themselves: nothing new is begun

  /// The slave has left the states with a mailbox: it begins to count anew.
  void restart() { receipt = {}; }
};

}  // namespace syncline
