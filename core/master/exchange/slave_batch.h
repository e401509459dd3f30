// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

class Bus;
struct Datagram;

/// Work on one slave that takes several datagrams one after the other: the one form of everything acyclic. Whoever has
/// time for nothing else runs it to its end (run_to_end()), many at once go side by side, and while the bus runs the
/// cyclic task sends a datagram of it now and then (cyclic/acyclic_scheduler).
class SlaveWork {
 public:
  virtual ~SlaveWork() = default;
  /// The datagram to send now; nullptr while it waits, and when it is over. Called once a round.
  virtual Datagram* next(Nanoseconds now) = 0;
  /// The datagram of this round came back (or nobody took it: working counter 0).
  virtual void take(Nanoseconds now) = 0;
  [[nodiscard]] virtual bool over() const = 0;
  /// How it ended. Allocates where it failed.
  [[nodiscard]] virtual Status result() const = 0;
  /// Its next datagram needs no pause before it; without bus cycles who polls a slave waits a little in between.
  [[nodiscard]] virtual bool in_a_hurry() const { return true; }
  /// Host clock before which it surely has no datagram; 0: it may have one at any time.
  [[nodiscard]] virtual Nanoseconds not_before() const { return 0; }
};

/// Does all works side by side: in each round one datagram of every work that has one, as many a frame
/// as fit. Each work keeps its own order and its own failure. An error here is one of the bus itself
/// (cancelled, link, no frame comes back) and ends all.
Status run_side_by_side(Bus& bus, std::span<SlaveWork* const> works);
/// One work to its end; the result is its own, or an error of the bus.
Status run_to_end(Bus& bus, SlaveWork& work);

}  // namespace syncline
