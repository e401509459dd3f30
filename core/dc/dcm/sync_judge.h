// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "support/types.h"

namespace syncline {
struct DcmSettings;
}  // namespace syncline

namespace syncline::dc {

/// Says from the controller error whether master and reference clock are in sync: after the start delay
/// the error must stay within the limit for the settle time; it is lost only by a violation or a silence
/// of the reference clock that lasts, because one late or lost frame is no loss of synchronisation.
class SyncJudge {
 public:
  /// So long a violation, or a silence, must last.
  static constexpr Nanoseconds kPatience = 200 * kMillisecond;

  explicit SyncJudge(const DcmSettings& settings);
  void start(Nanoseconds time);
  /// One cycle; `error` in ns.
  void observe(Nanoseconds time, Nanoseconds error);
  /// One cycle without a reading of the reference clock.
  void observe_silence(Nanoseconds time);
  /// What was known of the error is void (a clock has stepped): no patience.
  void lose();
  [[nodiscard]] bool in_sync() const { return in_sync_; }
  [[nodiscard]] bool was_in_sync() const { return after_.has_value(); }
  /// Not in sync any more because nothing was heard, and since then nothing has been beyond the limit.
  [[nodiscard]] bool lost_by_silence() const { return lost_by_silence_; }
  /// From start until the first time in sync, settle time included.
  [[nodiscard]] std::optional<Nanoseconds> in_sync_after() const { return after_; }

 private:
  void endure(std::optional<Nanoseconds>& since, Nanoseconds time);

  Nanoseconds limit_, settle_, delay_;
  Nanoseconds start_ = 0;
  std::optional<Nanoseconds> good_since_, bad_since_, silent_since_, after_;
  bool in_sync_ = false, lost_by_silence_ = false;
};

}  // namespace syncline::dc
