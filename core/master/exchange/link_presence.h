// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "channels/event.h"

namespace syncline {

class EventTeller;
struct Snapshot;

/// Whether the master's adapter is there, and how often it has gone away. The thread that runs the cycle.
class LinkPresence {
 public:
  /// `adapter`: name of the link, for what is told of it.
  LinkPresence(Snapshot& snapshot, EventTeller& teller, SharedText adapter);

  /// It is there, or away; tells a change.
  void note(bool up, Nanoseconds time);
  /// How often it has gone away.
  [[nodiscard]] unsigned outages() const { return outages_; }
  [[nodiscard]] std::optional<Nanoseconds> away_since() const { return away_since_; }

 private:
  Snapshot& snapshot_;
  EventTeller& teller_;
  SharedText adapter_;
  std::optional<Nanoseconds> away_since_;
  unsigned outages_ = 0;
};

}  // namespace syncline
