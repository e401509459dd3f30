// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "support/processor_wait.h"
#include "support/types.h"

namespace syncline {

struct JitterProfile;

/// Where the master, the simulator and the controllers get their time from. Implementations are
/// used by one thread at a time except now(), which any thread may call.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Nanoseconds since the DC epoch; never steps back.
  [[nodiscard]] virtual Nanoseconds now() const = 0;
  /// Returns at or after `deadline` (at once when it has passed).
  virtual void sleep_until(Nanoseconds deadline) = 0;
  /// The same, but the last `spin` of the wait is spent asking the clock instead of sleeping: a processor that is
  /// awake is on time where one that is woken up is late by tens of microseconds. Real clocks only. Returns how late it
  /// was woken up from sleeping; 0 where it did not sleep.
  virtual Nanoseconds sleep_until(Nanoseconds deadline, Nanoseconds spin) {
    (void)spin;
    sleep_until(deadline);
    return 0;
  }
  /// How long the calling thread has been kept waiting by others for its processor since it began; empty when that is
  /// not known, and on virtual time. Always to be asked by the same thread.
  [[nodiscard]] virtual std::optional<Nanoseconds> processor_wait() { return std::nullopt; }
  /// True when time passes only by sleep_until (virtual time).
  [[nodiscard]] virtual bool is_virtual() const = 0;
};

/// CLOCK_MONOTONIC, shifted to the DC epoch by what all programs of the machine agree on (SharedEpoch); absolute
/// wake-ups by clock_nanosleep(TIMER_ABSTIME).
class RealClock final : public Clock {
 public:
  RealClock();
  [[nodiscard]] Nanoseconds now() const override;
  void sleep_until(Nanoseconds deadline) override;
  Nanoseconds sleep_until(Nanoseconds deadline, Nanoseconds spin) override;
  [[nodiscard]] std::optional<Nanoseconds> processor_wait() override { return wait_.take(); }
  [[nodiscard]] bool is_virtual() const override { return false; }

 private:
  Nanoseconds epoch_shift_ = 0;
  ProcessorWait wait_;
};

/// Virtual time: sleep_until advances now() to the deadline and returns at once. With a jitter
/// profile a *wake-up* is late as on a real host, from its own seeded generator, so the same seed
/// gives the same run. advance_to() moves time without jitter (frames in flight). A standstill of the host delays
/// both: what would go on meanwhile goes on at its end. The profile's stalls come by chance, from that generator too.
class VirtualClock final : public Clock {
 public:
  /// Default start: 2025-12-25, the same each time, so that runs are repeatable.
  static constexpr Nanoseconds kDefaultStart = 820'000'000'000'000'000;

  explicit VirtualClock(Nanoseconds start = kDefaultStart);
  ~VirtualClock() override;
  /// From now on. Of the profile, its wake-ups and stalls.
  void set_wakeup_jitter(const JitterProfile& profile, std::uint64_t seed);
  /// The host does nothing from `begin` (absolute) until `begin + length`. Before time reaches it; any number of them,
  /// overlapping too.
  void add_standstill(Nanoseconds begin, Nanoseconds length);

  [[nodiscard]] Nanoseconds now() const override;
  using Clock::sleep_until;
  void sleep_until(Nanoseconds deadline) override;
  void advance_to(Nanoseconds time);
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace syncline
