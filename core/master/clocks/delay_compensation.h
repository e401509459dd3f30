// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "master/clocks/delay_latch.h"
#include "master/scan/topology.h"
#include "protocol/sdo_information.h"

namespace syncline {

struct ClockSegment;
struct DcNetwork;
struct DelaySurvey;
class EventTeller;
struct NetworkConfig;
class SlaveStates;
struct Snapshot;

/// Corrects 0x0928 while the bus runs, by datagrams that ride with its cycles, and in small steps, because each write
/// of that register is a step of what the slave's control loop sees. 0x0920 and 0x0930 stay: their writes would cost
/// the learned drift. Two reasons for it:
/// - Continuous compensation of the propagation delays (EC-Master emDcContDelayCompEnable), where it is switched on:
///   measures them again every 30 s, and corrects by a nanosecond at a time.
/// - Slaves went or came: whoever has measured the new tree calls renew().
///
/// What it sends and writes is sized at start() and renew(); the end of a measurement alone allocates, between two
/// cycles.
class DelayCompensation {
 public:
  static constexpr Nanoseconds kPeriod = 30 * kSecond;
  static constexpr Nanoseconds kStepPeriod = 100 * kMillisecond;
  /// As long as all steps may take when slaves went or came, for those behind them are off meanwhile: steps follow each
  /// other sooner for it, and are twice as large, but no sooner than a clock has followed the last one.
  static constexpr Nanoseconds kLongest = 2 * kSecond;
  static constexpr std::int64_t kCyclesToFollow = 10;
  /// Differences up to this are noise of the stamps.
  static constexpr std::uint32_t kDeadBand = 20;  // ns
  /// A larger one is no change of a delay but another segment.
  static constexpr std::uint32_t kLargestChange = 10'000;  // ns

  DelayCompensation(const NetworkConfig& config, Snapshot& snapshot, SlaveStates& states, EventTeller& teller)
      : config_(config), snapshot_(snapshot), states_(states), teller_(teller) {}
  DelayCompensation(const DelayCompensation&) = delete;
  DelayCompensation& operator=(const DelayCompensation&) = delete;

  /// After the DC initialisation.
  void start(const DcNetwork& network, Nanoseconds now);
  /// `slaves`, positions in the configuration, are who is on the bus now, and `survey` is of them in that order: from
  /// now on they are who is measured. Delays count from the clock that leads, whose own register stays. `step_ns`: how
  /// far a clock is moved at once; twice as far must not make it leave its place. Tells DelaysMeasured.
  void renew(std::vector<std::size_t> slaves, const DelaySurvey& survey, std::uint16_t leader, std::uint32_t step_ns,
             Nanoseconds now);
  /// While the bus runs; the first measurement comes a period after it was switched on.
  void set_enabled(bool enabled, Nanoseconds now);
  [[nodiscard]] bool enabled() const { return enabled_; }
  /// When the tree was measured that it counts with, host clock.
  [[nodiscard]] Nanoseconds measured_at() const { return measured_at_; }

  /// What is to be sent with the next cycle.
  [[nodiscard]] std::span<Datagram* const> requests(Nanoseconds now);
  /// The cycle is over. `leader`: position of the slave that leads the clocks now.
  void take(Nanoseconds now, std::optional<std::uint16_t> leader);

 private:
  enum class Step : std::uint8_t { kWait, kTrigger, kRead };
  struct Correction {
    std::uint32_t written = 0, target = 0, step = 1;
    std::array<std::uint8_t, 4> bytes{};
    Datagram datagram;
  };

  void use(std::vector<std::size_t> slaves, const ClockSegment& segment, std::uint16_t leader);
  void correct_to(const dc::DelayResult& delays, std::uint32_t least_step, std::uint32_t largest_change,
                  Nanoseconds now);
  void begin_round();
  void take_round(Nanoseconds now);
  void finish(Nanoseconds now);
  void give_up(Nanoseconds now);
  void add_corrections(Nanoseconds now);
  void take_corrections();
  [[nodiscard]] bool all_there() const;

  const NetworkConfig& config_;
  Snapshot& snapshot_;
  SlaveStates& states_;
  EventTeller& teller_;
  bool enabled_ = false;
  Step step_ = Step::kWait;
  std::unique_ptr<DelayLatch> latch_;
  std::vector<std::size_t> slaves_;  // positions in the configuration
  std::vector<SlaveWiring> wiring_;  // ClockSegment::wiring
  bool whole_ = false;               // ClockSegment::whole, then
  std::uint16_t reference_clock_ = 0;
  std::vector<Correction> corrections_;  // one a measured slave
  std::vector<Datagram*> requests_;
  std::size_t corrections_sent_ = 0;
  unsigned patience_ = 0;  // cycles that a round may still take
  unsigned failed_rounds_ = 0;
  Nanoseconds next_measurement_ = 0, next_step_ = 0, measured_at_ = 0;
  Nanoseconds step_period_ = kStepPeriod;
};

}  // namespace syncline
