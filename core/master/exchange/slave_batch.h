// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "master/exchange/bus.h"

namespace syncline {

/// Work on one slave that takes several datagrams one after the other: what a blocking call does, cut
/// into steps, so that many slaves can be worked on in the same frames.
class SlaveWork {
 public:
  virtual ~SlaveWork() = default;
  /// The datagram to send now; nullptr while it waits, and when it is over. Called once a round.
  virtual Datagram* next(Nanoseconds now) = 0;
  /// The datagram of this round came back (or nobody took it: working counter 0).
  virtual void take(Nanoseconds now) = 0;
  [[nodiscard]] virtual bool over() const = 0;
  /// How it ended.
  [[nodiscard]] virtual const Status& result() const = 0;
};

/// Does all works side by side: in each round one datagram of every work that has one, as many a frame
/// as fit. Each work keeps its own order and its own failure. An error here is one of the bus itself
/// (cancelled, link, no frame comes back) and ends all.
Status run_side_by_side(Bus& bus, std::span<SlaveWork* const> works);

}  // namespace syncline
