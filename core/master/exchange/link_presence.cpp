// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/link_presence.h"

#include <utility>

#include "channels/snapshot.h"
#include "master/exchange/event_teller.h"

namespace syncline {

LinkPresence::LinkPresence(Snapshot& snapshot, EventTeller& teller, SharedText adapter)
    : snapshot_(snapshot), teller_(teller), adapter_(std::move(adapter)) {}

void LinkPresence::note(bool up, Nanoseconds time) {
  snapshot_.link_up = up;
  if (up != away_since_.has_value()) return;  // nothing new
  if (up) {
    teller_.tell(time, -1, events::LinkUp{adapter_, time - *away_since_});
    away_since_.reset();
  } else {
    teller_.tell(time, -1, events::LinkDown{adapter_});
    away_since_ = time;
    ++outages_;
  }
}

}  // namespace syncline
