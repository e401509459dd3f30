// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "sim/device.h"

namespace syncline::sim {

/// Gateway to a CAN segment with one node that returns what it was sent. The CAN cycle starts with SYNC0, or
/// without DC with the SM2 event (SM3 when there are no outputs), every n-th time: n is 0xF800:04 (CAN cycle, ns)
/// by the bus cycle, 1 when it is 0. SYNC1 releases the CAN SYNC message, if it is used. A cycle that comes while
/// the CAN bus is still busy is counted in 0x1C32:0B and skipped.
class CanGateway final : public Device {
 public:
  CanGateway(const SimSlaveConfig& config, Esc& esc);

 protected:
  void on_outputs(Nanoseconds time) override;
  void on_inputs_read(Nanoseconds time) override;
  void on_sync0(Nanoseconds time) override;
  void on_sync1(Nanoseconds time) override;
  void on_state(AlState state) override;
  std::uint16_t check_sync(AlState to) override;
  void check_running(Nanoseconds time) override;

 private:
  void bus_cycle(Nanoseconds time);
  void send_sync_message(Nanoseconds time);
  /// Gives the node's answer to the process data, or says that it did not come in time.
  void latch_inputs(Nanoseconds time);

  std::uint32_t multiplier_ = 1, bus_cycles_ = 0;
  Nanoseconds busy_until_ = 0;
  std::optional<Nanoseconds> latch_at_;     // input shift time behind the start of the CAN cycle
  std::optional<Nanoseconds> sync_due_;     // CAN cycle that waits for its SYNC message
  std::optional<Nanoseconds> answer_at_;    // the node's answer is complete
  std::uint32_t sent_ = 0;                  // what the node was sent in this CAN cycle
};

}  // namespace syncline::sim
