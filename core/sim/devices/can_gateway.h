// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "sim/device/device.h"
#include "sim/devices/sync_object.h"
#include "sim/segment/pin_trace.h"

namespace syncline::sim {

/// Gateway to a CAN segment with one node that returns what it was sent. The CAN cycle starts with SYNC0, or
/// without DC with the SM2 event (SM3 when there are no outputs), every n-th time: n is 0xF800:04 (CAN cycle, ns)
/// by the bus cycle 0x1C32:02, 1 when one of them is 0. SYNC1 releases the CAN SYNC message, if it is used. A cycle
/// that comes while the CAN cycle before it is not over is counted as exceeded in 0x1C32 (0x1C33 without outputs) and
/// skipped. Output pin 1 shows the SYNC messages on the CAN bus.
class CanGateway final : public Device {
 public:
  CanGateway(const SimSlaveConfig& config, Esc& esc);
  [[nodiscard]] const PinTrace* output_pin(unsigned number) const override {
    return number == 1 ? &can_sync_ : nullptr;
  }

 protected:
  void on_outputs(Nanoseconds time) override;
  void on_inputs_read(Nanoseconds time) override;
  [[nodiscard]] bool minds_inputs_read() const override { return true; }
  void on_sync0(Nanoseconds time) override;
  void on_sync1(Nanoseconds time) override;
  void on_state(AlState state) override;
  std::uint16_t check_sync(AlState to) override;
  void check_running(Nanoseconds time) override;

 private:
  void add_parameters();
  void bus_cycle(Nanoseconds time);
  void synchronous_cycle(Nanoseconds time);
  void asynchronous_cycle(Nanoseconds time);
  void send_sync_message(Nanoseconds time);
  /// What has come from the node by `time` goes to the process data.
  void update_inputs(Nanoseconds time);
  /// The node's answer had to be here by `time`.
  void check_node(Nanoseconds time);
  void set_node_state(std::uint8_t state);
  [[nodiscard]] Nanoseconds parameter(std::uint8_t sub_index);
  [[nodiscard]] Nanoseconds tx_pdo_delay();
  [[nodiscard]] Nanoseconds vary(Nanoseconds largest);

  SyncObject outputs_sync_, inputs_sync_;
  PinTrace can_sync_;
  std::uint32_t multiplier_ = 1, bus_cycles_ = 0;
  bool fresh_outputs_ = false;
  Nanoseconds busy_until_ = 0;
  Nanoseconds bus_cycle_ns_ = 0;                     // of SYNC0 or told by the master; 0: not known
  std::optional<Nanoseconds> update_at_, check_at_;  // input shift time behind this bus cycle
  bool unchecked_ = false;                           // a CAN cycle was started whose answer was not looked for yet
  bool check_at_next_ = false;                       // no input shift time: when the next cycle begins
  std::optional<Nanoseconds> sync_due_;              // CAN cycle that waits for its SYNC message
  std::optional<Nanoseconds> answer_at_;             // the node's answer is complete
  std::uint32_t sent_ = 0;                           // what the node was sent in this CAN cycle
  std::uint32_t noise_ = 6751;
};

}  // namespace syncline::sim
