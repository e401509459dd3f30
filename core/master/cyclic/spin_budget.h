// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "support/types.h"

namespace syncline {

/// How long the end of each wait is spent asking the clock instead of sleeping: as long as this host needs so that 99
/// of 100 frames leave in time, and not longer; where some wake up so late that no spin catches them, 99 of 100 less
/// those. In time is what is late by no more than `tolerated`: slaves with SYNC0 take over at SYNC0, and the control
/// loops know when each frame left. What comes later than that no spinning would catch. Allocates nothing.
class SpinBudget {
 public:
  /// `most`: the user's limit; 0 never spins.
  explicit SpinBudget(Nanoseconds most, Nanoseconds tolerated = 0)
      : most_(most), tolerated_(tolerated), amount_(most) {}
  /// Of a cycle: late by so little changes nothing. Sync managers want their frame a good part of the cycle before
  /// SYNC0 (two thirds of it by default), so that this is a small part of what there is.
  [[nodiscard]] static Nanoseconds tolerated(Nanoseconds cycle_time) { return cycle_time / 20; }

  [[nodiscard]] Nanoseconds amount() const { return amount_; }
  /// How late the host was woken up from the sleep before the spinning; 0 when it did not sleep.
  void observe(Nanoseconds wake_late);

  /// Of the latest some hundred wake-ups, ns; the upper edge of a bin that is an eighth of an octave wide.
  [[nodiscard]] Nanoseconds wake_p50() const { return p50_; }
  [[nodiscard]] Nanoseconds wake_p99() const { return p99_; }
  /// What a cycle spends with it in the mean, since the start, ns.
  [[nodiscard]] Nanoseconds mean_spent() const { return wakes_ == 0 ? 0 : spent_ / static_cast<Nanoseconds>(wakes_); }

 private:
  static constexpr std::size_t kBins = 256;
  [[nodiscard]] Nanoseconds quantile(double share) const;
  [[nodiscard]] double share_within(Nanoseconds late) const;
  void adapt();

  Nanoseconds most_, tolerated_, amount_;
  std::array<std::uint16_t, kBins> bins_{};
  std::uint32_t counted_ = 0;
  std::uint64_t wakes_ = 0;
  Nanoseconds spent_ = 0, p50_ = 0, p99_ = 0;
};

}  // namespace syncline
