// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "channels/values/bus_scan.h"
#include "config/network_config.h"
#include "dc/propagation_delay.h"
#include "master/clocks/clock_segment.h"
#include "master/exchange/frame_exchange.h"
#include "master/exchange/slave_address.h"

namespace syncline {

class Bus;
struct DcMasterSettings;
class DelayLatch;

/// The distributed clocks of a segment after their initialisation.
struct DcNetwork {
  struct Slave {
    DcCapability capability = DcCapability::kNone;
    bool synchronised = false;   // has a system time and stands behind the reference clock, or is it
    std::uint32_t delay_ns = 0;  // from the reference clock
  };
  std::vector<Slave> slaves;
  std::uint16_t reference_clock = 0;
  /// Who is to lead whenever it is there: the configured reference clock, unless it cannot.
  std::uint16_t home = 0;
  /// The configured reference clock, when its system time does not answer: the next one leads in its place.
  std::optional<std::uint16_t> without_time;
  /// A host time and the reference clock's system time at that moment.
  Nanoseconds host_time = 0, reference_time = 0;
  std::vector<dc::DelayFinding> findings;
  /// The slaves that were measured: their positions in the configuration, and how they are wired.
  std::vector<std::size_t> measured;
  ClockSegment segment;
  std::uint32_t burst_frames = 0;
  bool settled = false;  // the burst ended because all clocks were near each other

  [[nodiscard]] std::size_t synchronised_count() const;
};

/// Measures the propagation delays, sets offsets and delays, and lets the slaves learn their drift by a
/// burst of ARMW frames (reference: ESC data sheet I, 9.1). Slaves must have their station addresses;
/// no cyclic operation. An ENI has no commands for this: every master does it by itself.
class DcSetup {
 public:
  /// `slaves`: those of the configuration that are on the bus, in frame order; others get no clock.
  DcSetup(Bus& bus, const NetworkConfig& config, std::vector<std::size_t> slaves)
      : bus_(bus), config_(config), slaves_(std::move(slaves)) {}

  /// kDcSetup when no clock can lead; kCancelled, link errors.
  Result<DcNetwork> run();

 private:
  struct Write {
    std::size_t slave;
    std::uint16_t address;
    std::vector<std::uint8_t> bytes;
    bool optional = false;  // not every ESC has the register
  };

  Status read_slaves();
  Status choose_reference();
  [[nodiscard]] DcNetwork for_all_slaves() const;
  [[nodiscard]] bool complete() const { return slaves_.size() == config_.slaves.size(); }
  [[nodiscard]] bool steered() const;
  Status measure();
  Result<bool> latch_round(DelayLatch& latch);
  Status write_times(const DelayLatch& latch);
  void add_loop_values(std::size_t slave, std::vector<Write>& filters) const;
  Status write_all(std::span<Write> writes);
  Status see_whether_taken(std::span<const Write> times);
  Status burst();
  [[nodiscard]] std::string subject(std::size_t slave) const;

  Bus& bus_;
  const NetworkConfig& config_;
  std::vector<std::size_t> slaves_;  // what follows counts these
  std::vector<SlaveAddress> addresses_;
  ClockSegment segment_;
  DcNetwork network_;
  Nanoseconds latch_time_ = 0;  // host time of the latest latch
  PendingFrame frame_;
};

/// tDiff of the configuration, or the usual ones.
[[nodiscard]] dc::DelayOptions delay_options(const DcMasterSettings& settings);
/// Position of the clock that all others follow: as configured, else the first slave with DC.
[[nodiscard]] std::optional<std::uint16_t> configured_reference_clock(const NetworkConfig& config);

}  // namespace syncline
