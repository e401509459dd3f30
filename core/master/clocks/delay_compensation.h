// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "master/clocks/dc_setup.h"
#include "master/clocks/delay_latch.h"
#include "master/exchange/run_state.h"

namespace syncline {

/// Continuous compensation of the propagation delays (EC-Master emDcContDelayCompEnable): measures them again every
/// 30 s by datagrams that ride with the bus cycles, and corrects 0x0928 by a nanosecond at a time, because each write
/// of that register is a step of the clock. 0x0920 and 0x0930 stay: their writes would cost the learned drift.
/// What it sends and writes is sized at start(); the end of a measurement alone allocates, between two cycles.
class DelayCompensation {
 public:
  static constexpr Nanoseconds kPeriod = 30 * kSecond;
  static constexpr Nanoseconds kStepPeriod = 100 * kMillisecond;
  /// Differences up to this are noise of the stamps.
  static constexpr std::uint32_t kDeadBand = 20;  // ns
  /// A larger one is no change of a delay but another segment.
  static constexpr std::uint32_t kLargestChange = 10'000;  // ns

  explicit DelayCompensation(RunState& run) : run_(run) {}
  DelayCompensation(const DelayCompensation&) = delete;
  DelayCompensation& operator=(const DelayCompensation&) = delete;

  /// After the DC initialisation.
  void start(const DcNetwork& network, Nanoseconds now);
  /// While the bus runs; the first measurement comes a period after it was switched on.
  void set_enabled(bool enabled, Nanoseconds now);
  [[nodiscard]] bool enabled() const { return enabled_; }

  /// What is to be sent with the next cycle.
  [[nodiscard]] std::span<Datagram* const> requests(Nanoseconds now);
  /// The cycle is over. `leader`: position of the slave that leads the clocks now.
  void take(Nanoseconds now, std::optional<std::uint16_t> leader);

 private:
  enum class Step : std::uint8_t { kWait, kTrigger, kRead };
  struct Correction {
    std::uint32_t written = 0, target = 0;
    std::array<std::uint8_t, 4> bytes{};
    Datagram datagram;
  };

  void begin_round();
  void take_round(Nanoseconds now);
  void finish(Nanoseconds now);
  void give_up(Nanoseconds now);
  void add_corrections(Nanoseconds now);
  void take_corrections();
  [[nodiscard]] bool all_there() const;

  RunState& run_;
  bool enabled_ = false;
  Step step_ = Step::kWait;
  std::unique_ptr<DelayLatch> latch_;
  std::vector<std::size_t> slaves_;  // positions in the configuration
  std::vector<DlStatus> dl_status_;
  std::uint16_t reference_clock_ = 0;
  std::vector<Correction> corrections_;  // one a measured slave
  std::vector<Datagram*> requests_;
  std::size_t corrections_sent_ = 0;
  unsigned patience_ = 0;  // cycles that a round may still take
  unsigned failed_rounds_ = 0;
  Nanoseconds next_measurement_ = 0, next_step_ = 0;
};

}  // namespace syncline
