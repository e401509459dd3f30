// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "dc/dcm/write_forecast.h"
#include "support/types.h"

namespace syncline::dc {

struct DcmObservation;

/// What a clock is told that leads for another one, where the mode tells the clock that leads the nominal time. Its
/// control loop is that of those who follow: it goes as far as they do towards each message, and they would be as far
/// behind it as that was wrong, by the host's jitter. So it is told the time that it will show by itself, less a little
/// of how far it is from its place on average; then nobody notices, and its loop learns its quartz. Values only; one
/// thread.
class SubstitutePush {
 public:
  /// `limit`, ns: nMaxValidVal, see OutlierGate.
  explicit SubstitutePush(double limit) : forecast_(limit) {}
  /// It begins to lead: nothing is known of it.
  void start();
  /// A reading of one cycle (with reference time), `lag` ns ahead of its place. True: its frame left far from the stamp
  /// that its message was made for, which another write shall take back.
  bool take(const DcmObservation& observation, Nanoseconds lag);
  /// A reading of that write; true when that one, too, left far from its stamp.
  bool take_again(const DcmObservation& observation, Nanoseconds lag);
  /// The message of a frame with this stamp; nothing before the first reading.
  [[nodiscard]] std::optional<Nanoseconds> told_at(Nanoseconds stamp) const;

 private:
  WriteForecast forecast_;
  double lag_ = 0;    // on average, ns
  int readings_ = 0;  // no more than count
};

}  // namespace syncline::dc
