// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "channels/values/shared_text.h"
#include "support/types.h"

/// Cycles, frames and the master's own adapter.
namespace syncline::events {

/// Told when a spell of wrong counters begins, and with the count when a longer one is over.
struct WkcError {
  std::uint16_t expected = 0;
  std::uint16_t received = 0;
  std::uint64_t count = 1;
};

struct WkcExpected {
  std::uint16_t configured = 0;  // with all slaves
  std::uint16_t now = 0;         // without slaves that are lost or below SAFEOP
};

/// Each lost frame is in exactly one of these, see MissingFrames.
struct FramesLost {
  std::int64_t count = 0;
};

struct FramesLate {
  std::int64_t count = 0;         // came back after their deadline
  Nanoseconds late_by = 0;        // at most
  std::int64_t told_as_lost = 0;  // part of them that a FramesLost had counted before
};

/// The host came too late for them.
struct CyclesLeftOut {
  std::int64_t count = 0;
  Nanoseconds standstill = 0;  // longest time without a frame
};

/// The master's adapter is gone or without carrier.
struct LinkDown {
  SharedText adapter;
};
struct LinkUp {
  SharedText adapter;
  Nanoseconds away = 0;
};
/// The adapter was away in the middle of a bring-up, which begins again.
struct BringUpAgain {};

}  // namespace syncline::events
