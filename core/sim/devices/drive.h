// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device/device.h"
#include "sim/device/own_loop.h"
#include "sim/devices/power_state.h"
#include "sim/devices/servo_axis.h"
#include "sim/devices/servo_clock.h"
#include "sim/devices/sync_object.h"

namespace syncline::sim {

/// What distinguishes one vendor's drive from another's: the table of device families, and what is the simulation's
/// own.
struct DriveHabits {
  /// Of a family with cycle limits, error limit, counters, times and types. `supported`: SyncHabits::Supported.
  DriveHabits(const families::Family& family, std::uint16_t supported);

  families::CycleLimits cycle;  // of SYNC0
  std::uint32_t servo_period_ns;
  SyncHabits sync;
  families::ErrorLimit error_limit;  // 0x10F1:02, and what happens at the limit
  bool cyclic_modes_need_dc;         // without SYNC0 no cyclic synchronous mode
  bool pll = false;                  // the servo timer follows SYNC0; otherwise SYNC0 restarts it
};

/// CiA 402 drive with profile position, interpolated position and the cyclic synchronous modes for position and
/// velocity: sync objects 0x1C32 and 0x1C33, free run or SYNC0, missed SM2 events with the +3/-1 integrator of
/// 0x10F1:02.
class Drive : public Device {
 public:
  Drive(const SimSlaveConfig& config, Esc& esc, const DriveHabits& habits);

 protected:
  void on_outputs(Nanoseconds time) override;
  void on_sync0(Nanoseconds time) override;
  void on_state(AlState state) override;
  std::uint16_t check_sync(AlState to) override;
  bool settling(AlState wanted, Nanoseconds waited) override;
  void check_running(Nanoseconds time) override;
  void on_resumed(Nanoseconds time) override;
  Nanoseconds runs_alone_until() override;
  std::optional<Nanoseconds> repeats() override;
  void on_cycles_passed(std::uint64_t count, Nanoseconds time) override;
  /// A servo period begins.
  virtual void servo_tick(Nanoseconds) {}
  /// Somebody looks at servo_tick(), so that none may be left out.
  void watch_servo(bool watched) { watched_ = watched; }
  [[nodiscard]] const DriveHabits& habits() const { return habits_; }
  [[nodiscard]] const ServoClock& servo_clock() const { return clock_; }
  /// Inputs are those of SYNC0; otherwise those of the last servo period.
  [[nodiscard]] bool latches_at_sync0() { return inputs_sync_.type() == SyncType::kSync0 && dc().sync0_enabled(); }
  [[nodiscard]] bool synchronised() { return outputs_sync_.type() == SyncType::kSync0 && dc().sync0_enabled(); }

 private:
  /// Outputs on their way from the SyncManager into the application.
  struct Arriving {
    AxisCommand command;
    Nanoseconds ready = 0;
  };
  void add_objects();
  /// Keeps what the ESI says of an object, and gives it the value of a drive that is switched on.
  template <std::unsigned_integral T>
  ObjectValue<T> object(std::uint16_t index, std::uint8_t sub_index, const char* name, T value, std::uint16_t type,
                        bool writable = false);
  void choose_types();
  void leave_op();
  /// When SYNC0 will have stayed away for too long.
  [[nodiscard]] Nanoseconds sync_patience() const;
  /// What the objects tell the axis now.
  [[nodiscard]] const AxisCommand& command();
  [[nodiscard]] AxisCommand read_command(bool sync0);
  [[nodiscard]] Nanoseconds target_distance();
  void take_arrived(Nanoseconds time);
  void take_event(Nanoseconds time);
  void count_sync_event(bool missed);
  void raise_sync_alarm();
  void begin_local_cycle(Nanoseconds time);
  [[nodiscard]] static Nanoseconds end_of(const SyncObject::LocalTimes& times) {
    return times.calc_and_copy + times.delay;
  }
  /// Lets the servo loop run up to `time`, and latches the inputs when the shift time puts them in between.
  void run_servo(Nanoseconds time) {
    if (latch_due_ || !passes_over_periods()) run_each_period(time);
  }
  /// Nobody sees a servo period, and SYNC0 passes over them.
  [[nodiscard]] bool passes_over_periods() { return !axis_.enabled() && !watched_ && latches_at_sync0(); }
  void run_each_period(Nanoseconds time);
  void run_ticks(Nanoseconds time);
  void apply(const AxisCommand& command, Nanoseconds time);
  void publish_inputs();
  [[nodiscard]] bool shows_plain_inputs();
  [[nodiscard]] std::uint16_t statusword();

  /// Objects of every cycle.
  struct Objects {
    ObjectValue<std::uint16_t> error_code, control, status, sync_error_limit;
    ObjectValue<std::uint8_t> mode, mode_display, interpolation_time, interpolation_index;
    ObjectValue<std::uint32_t> demand, actual, velocity, target, target_velocity, profile_velocity,
        profile_acceleration, point, following_error;
  };

  /// What is in the inputs beside the axis.
  struct Published {
    std::uint16_t status = 0, error_code = 0;
    std::uint8_t mode = 0;
    bool operator==(const Published&) const = default;
  };

  DriveHabits habits_;
  Objects objects_;
  std::optional<Published> published_;
  bool steady_ = false;        // the last command changed nothing, nor would it now
  bool plain_inputs_ = false;  // nothing else
  bool watched_ = false;
  /// The last one that was read, and what it was read from.
  struct KnownCommand {
    AxisCommand command;
    std::uint32_t outputs = 0;
    bool sync0 = false;
  };
  std::optional<KnownCommand> known_command_;
  SyncObject outputs_sync_, inputs_sync_;
  OwnLoop loop_;  // without SYNC0
  ServoClock clock_;
  PowerState power_;
  ServoAxis axis_;
  std::optional<Arriving> arriving_;
  std::optional<AxisCommand> arrived_;    // for the next SYNC0
  std::optional<Nanoseconds> last_sync_;  // since PREOP
  std::optional<Nanoseconds> latch_due_;
  Nanoseconds busy_until_ = 0;
  bool any_outputs_ = false, was_op_ = false;
  std::optional<Nanoseconds> waiting_;    // newer outputs than those on their way, and how long copying them will take
  std::optional<Nanoseconds> event_due_;  // when the outputs of the last SM2 event are there, if nothing delays them
  bool event_in_time_ = false;            // there was one for the next SYNC0
  unsigned integrator_ = 0;
};

}  // namespace syncline::sim
