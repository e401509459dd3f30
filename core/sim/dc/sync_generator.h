// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace syncline::sim {

/// Cyclic unit of an ESC: when SYNC0 and SYNC1 are due, in system time of the ESC (local + offset).
/// Knows no clock; the DC unit compares (ESC data sheet I, 9.2).
class SyncGenerator {
 public:
  struct Settings {
    bool sync0 = false;
    bool sync1 = false;
    std::uint32_t cycle0 = 0;  // ns, 0 = single shot
    std::uint32_t cycle1 = 0;  // ns, delay of SYNC1 behind its SYNC0; 0 = copy of SYNC0
  };
  enum class Signal : std::uint8_t { kSync0, kSync1 };
  struct Due {
    std::uint64_t time = 0;
    Signal signal = Signal::kSync0;
  };

  /// Unit on; the first SYNC0 comes at `first` (never, when empty: the start time has passed).
  void activate(const Settings& settings, std::optional<std::uint64_t> first);
  void deactivate();
  [[nodiscard]] bool active() const { return active_; }
  [[nodiscard]] bool sync0_pending() const { return active_ && settings_.sync0 && !first0_done_; }
  [[nodiscard]] bool sync1_pending() const { return active_ && settings_.sync1 && !first1_done_; }
  [[nodiscard]] std::optional<std::uint64_t> next_sync0() const { return next0_; }
  /// The last SYNC1 that was set up, to come or past; 0: none yet.
  [[nodiscard]] std::uint64_t latest_sync1() const { return latest1_; }
  /// The earliest signal; SYNC0 before a coincident SYNC1.
  [[nodiscard]] std::optional<Due> due() const;
  /// SYNC0 of a unit without SYNC1 has come.
  void pass_sync0() {
    first0_done_ = true;
    next0_ = *next0_ + settings_.cycle0;
  }
  /// The signal of due() has come.
  void fired();
  /// System time has jumped to `now` (offset written, clock step): pulses that were jumped over are lost.
  /// A unit of 32 bit sees the low word only: what is due lies within one turn of it.
  void realign(std::uint64_t now, bool wide);
  /// Nobody has looked for long: what was due before `now` has come and gone. How many SYNC0 that were.
  std::uint64_t skip_to(std::uint64_t now);
  /// The same of a unit without SYNC1 whose SYNC0 comes in cycles: in every frame.
  std::uint64_t skip_regular_to(std::uint64_t now) {
    const auto since = static_cast<std::int64_t>(now - *next0_);
    if (since <= 0) return 0;
    const auto passed = since < settings_.cycle0 ? 1 : static_cast<std::uint64_t>(since) / settings_.cycle0 + 1;
    next0_ = *next0_ + passed * settings_.cycle0;
    first0_done_ = true;
    return passed;
  }

 private:
  std::uint64_t pass_to(std::uint64_t now);
  void start_sync1(std::uint64_t sync0);

  Settings settings_;
  bool active_ = false;
  bool first0_done_ = false, first1_done_ = false;
  std::optional<std::uint64_t> next0_, next1_;
  std::uint64_t latest1_ = 0;
};

}  // namespace syncline::sim
