// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "config/project.h"
#include "support/types.h"

namespace syncline::dc {

/// Slaves in sync when the wire-ored SystemTimeDifference stays within 2^n - 1 ns for the settle
/// time; out of sync at once when it leaves. States and transitions only.
class SyncWindowMonitor {
 public:
  enum class State : std::uint8_t { kNotMonitored, kSettling, kInSync, kOutOfSync };
  enum class Edge : std::uint8_t { kNone, kInSync, kOutOfSync };

  SyncWindowMonitor() = default;
  /// `monitored`: configured and at least two DC slaves.
  SyncWindowMonitor(const SyncWindowSettings& settings, bool monitored, Nanoseconds start);
  /// One reading; the magnitude of the wire-ored value.
  Edge observe(Nanoseconds time, std::uint32_t ored_magnitude_ns);
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] std::uint32_t limit_ns() const { return limit_ns_; }
  /// Time from start to the beginning of the settle time that led to in sync.
  [[nodiscard]] std::optional<Nanoseconds> settled_after() const { return settled_after_; }

 private:
  State state_ = State::kNotMonitored;
  std::uint32_t limit_ns_ = 0;
  Nanoseconds settle_ns_ = 0, start_ = 0;
  std::optional<Nanoseconds> good_since_, settled_after_;
};

}  // namespace syncline::dc
