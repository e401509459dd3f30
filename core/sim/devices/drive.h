// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device.h"

namespace syncline::sim {

/// What distinguishes one vendor's drive from another's.
struct DriveHabits {
  std::uint32_t cycle_step_ns = 125'000;      // SYNC0 cycle must be a multiple
  std::uint32_t cycle_max_ns = 4'000'000;
  std::uint8_t sm_missed_sub_index = 0x0C;    // of 0x1C32: 0x0C in the older object layout, 0x0B in the newer
  std::uint16_t sync_error_limit = 9;         // 0x10F1:02, default
  std::uint16_t sync_error_limit_max = 15;
  std::uint16_t sync_alarm = 0x0A12;          // 0x603F when the limit is reached
};

/// CiA 402 drive in cyclic synchronous position mode, synchronised by SYNC0 or SM2: sync objects 0x1C32
/// and 0x1C33, missed SM2 events with the +3/-1 integrator of 0x10F1:02.
class Drive : public Device {
 public:
  Drive(const SimSlaveConfig& config, Esc& esc, const DriveHabits& habits);

 protected:
  void on_outputs(Nanoseconds time) override;
  void on_sync0(Nanoseconds time) override;
  void on_state(AlState state) override;
  std::uint16_t check_sync(AlState to) override;
  void check_running(Nanoseconds time) override;
  /// Once a servo cycle.
  virtual void servo_cycle(Nanoseconds) {}
  [[nodiscard]] const DriveHabits& habits() const { return habits_; }

 private:
  void add_objects();
  void count_sync_event();
  void move();
  void power_state_machine();

  DriveHabits habits_;
  bool outputs_since_sync_ = false, any_outputs_ = false;
  std::optional<Nanoseconds> last_sync_;  // since PREOP
  unsigned integrator_ = 0;
};

}  // namespace syncline::sim
