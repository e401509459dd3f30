// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/drive.h"

#include <algorithm>
#include <functional>

#include "protocol/registers.h"
#include "protocol/sync_error_counter.h"

namespace syncline::sim {
namespace {

constexpr std::uint32_t kPllRange = 100'000;  // ns; the drive's PLL cannot lock on a clock that is further away
constexpr Nanoseconds kPllPatience = 2 * kSecond;
/// Servo periods that are run through at once at most: a drive that nobody has asked for so long has come to rest.
constexpr Nanoseconds kMostTicks = 100'000;
constexpr std::uint32_t kCurrentLoop = 62'500;  // ns

// ETG.1000.6, table 64
constexpr std::uint16_t kSigned8 = 0x02, kSigned32 = 0x04, kUnsigned8 = 0x05, kUnsigned16 = 0x06, kUnsigned32 = 0x07;

constexpr std::uint16_t kControl = 0x6040, kStatus = 0x6041, kMode = 0x6060, kModeDisplay = 0x6061, kDemand = 0x6062,
                        kActual = 0x6064, kVelocity = 0x606C, kTarget = 0x607A, kProfileVelocity = 0x6081,
                        kProfileAcceleration = 0x6083, kInterpolationPoint = 0x60C1, kInterpolationTime = 0x60C2,
                        kFollowingError = 0x60F4, kTargetVelocity = 0x60FF, kErrorCode = 0x603F,
                        kErrorSettings = 0x10F1;

/// Where the free-running timer stands when nobody leads it: anywhere, but the same in each run.
Nanoseconds timer_phase(const SimSlaveConfig& config) {
  const auto hash =
      std::hash<std::uint64_t>{}(config.serial_no * 7919ULL + config.parent.value_or(77) * 104'729ULL + 12'345ULL);
  return static_cast<Nanoseconds>(hash * 2'654'435'761ULL % 1'000'003ULL);
}

}  // namespace

DriveHabits::DriveHabits(const families::Family& family, std::uint16_t supported)
    : cycle(*family.cycle),
      servo_period_ns(static_cast<std::uint32_t>(family.cycle->full_step)),
      sync(family, supported, static_cast<std::uint32_t>(family.cycle->shortest)),
      error_limit(*family.error_limit),
      cyclic_modes_need_dc(std::ranges::any_of(family.modes_need_dc.list, &families::ModeNeedsDc::refused)) {}

Drive::Drive(const SimSlaveConfig& config, Esc& esc, const DriveHabits& habits)
    : Device(config, esc),
      habits_(habits),
      outputs_sync_(dictionary_, SyncObject::kOutputs, habits.sync),
      inputs_sync_(dictionary_, SyncObject::kInputs, habits.sync),
      loop_(esc),
      clock_(habits.servo_period_ns, config.oscillator.ppm, timer_phase(config)) {
  add_objects();
  enable_diagnosis_history();
}

template <std::unsigned_integral T>
ObjectValue<T> Drive::object(std::uint16_t index, std::uint8_t sub_index, const char* name, T value, std::uint16_t type,
                             bool writable) {
  auto* entry = dictionary_.find(index, sub_index);
  if (entry == nullptr || entry->value.size() != sizeof(T)) {
    entry = &dictionary_.add(index, sub_index, name, value, writable);
    entry->data_type = type;
  }
  entry->value = le_bytes(value);
  return ObjectValue<T>(*entry);
}

void Drive::add_objects() {
  auto& o = objects_;
  o.error_code = object<std::uint16_t>(kErrorCode, 0, "Error code", 0, kUnsigned16);
  o.control = object<std::uint16_t>(kControl, 0, "Controlword", 0, kUnsigned16, true);
  o.status = object<std::uint16_t>(kStatus, 0, "Statusword", power_.statusword(), kUnsigned16);
  o.mode = object<std::uint8_t>(kMode, 0, "Modes of operation", 8, kSigned8, true);
  o.mode_display = object<std::uint8_t>(kModeDisplay, 0, "Modes of operation display", 0, kSigned8);
  o.demand = object<std::uint32_t>(kDemand, 0, "Position demand value", 0, kSigned32);
  o.actual = object<std::uint32_t>(kActual, 0, "Position actual value", 0, kSigned32);
  o.velocity = object<std::uint32_t>(kVelocity, 0, "Velocity actual value", 0, kSigned32);
  o.target = object<std::uint32_t>(kTarget, 0, "Target position", 0, kSigned32, true);
  o.target_velocity = object<std::uint32_t>(kTargetVelocity, 0, "Target velocity", 0, kSigned32, true);
  o.profile_velocity = object<std::uint32_t>(kProfileVelocity, 0, "Profile velocity", 100'000, kUnsigned32, true);
  o.profile_acceleration =
      object<std::uint32_t>(kProfileAcceleration, 0, "Profile acceleration", 1'000'000, kUnsigned32, true);
  o.following_error = object<std::uint32_t>(kFollowingError, 0, "Following error actual value", 0, kSigned32);
  dictionary_.set_object_name(kInterpolationPoint, "Interpolation data record");
  object<std::uint8_t>(kInterpolationPoint, 0, "Number of entries", 1, kUnsigned8);
  o.point = object<std::uint32_t>(kInterpolationPoint, 1, "Interpolation position", 0, kSigned32, true);
  dictionary_.set_object_name(kInterpolationTime, "Interpolation time period");
  object<std::uint8_t>(kInterpolationTime, 0, "Number of entries", 2, kUnsigned8);
  o.interpolation_time =
      object<std::uint8_t>(kInterpolationTime, 1, "Interpolation time period value", 1, kUnsigned8, true);
  o.interpolation_index = object<std::uint8_t>(kInterpolationTime, 2, "Interpolation time index", 0xFD, kSigned8, true);
  dictionary_.set_object_name(kErrorSettings, "Error settings");
  object<std::uint8_t>(kErrorSettings, 0, "Number of entries", 2, kUnsigned8);
  object<std::uint32_t>(kErrorSettings, 1, "Local error reaction", 1, kUnsigned32, true);
  o.sync_error_limit = object<std::uint16_t>(kErrorSettings, 2, "Sync error counter limit", habits_.error_limit.usual,
                                             kUnsigned16, true);
  dictionary_.find(kErrorSettings, 2)->on_write = [this](std::span<const std::uint8_t> data) {
    return load_le<std::uint16_t>(data) <= habits_.error_limit.largest ? abort::kNone : abort::kRange;
  };
}

// ---- AL state ------------------------------------------------------------------------------------

std::uint16_t Drive::check_sync(AlState to) {
  const auto& unit = dc();
  if (!unit.sync_active()) {
    // A type that nobody has written means no more than that SYNC0 would be used.
    const auto wants = [](const SyncObject& object) { return object.type_told() && object.type() == SyncType::kSync0; };
    const bool wanted = wants(outputs_sync_) || wants(inputs_sync_);
    return wanted && !habits_.sync.types.follow_dc ? al_code::kInvalidSyncConfiguration : std::uint16_t{0};
  }
  const auto cycle = unit.settings().cycle0;
  if (cycle == 0 || cycle % habits_.cycle.step != 0) return al_code::kInvalidSync0Cycle;
  if (cycle > habits_.cycle.longest) return al_code::kInvalidSyncCycle;
  if (unit.settings().sync1 && unit.settings().cycle1 % habits_.cycle.step != 0) return al_code::kInvalidSync1Cycle;
  if (inputs_sync_.shift() >= cycle) return al_code::kInvalidSyncConfiguration;
  if (to != AlState::kOp) return 0;
  // OP needs a SYNC0 that comes: a start time in the past never fires.
  if (!last_sync_) return al_code::kNoSync;
  if (unit.deviation_magnitude() > kPllRange || !clock_.locked()) return al_code::kPllError;
  return 0;
}

/// OP waits for the PLL, as long as SYNC0 comes and there is hope.
bool Drive::settling(AlState wanted, Nanoseconds waited) {
  return wanted == AlState::kOp && habits_.pll && dc().sync_active() && last_sync_ && !clock_.locked() &&
         waited < kPllPatience;
}

void Drive::choose_types() {
  const auto& unit = dc();
  const bool sync0 = unit.sync0_enabled();
  const auto cycle = unit.settings().cycle0;
  for (auto* object : {&outputs_sync_, &inputs_sync_}) {
    if (habits_.sync.types.follow_dc) object->set_type(sync0 ? SyncType::kSync0 : SyncType::kFreeRun);
    object->set_cycle(sync0 ? cycle : habits_.servo_period_ns);
    object->set_sync0_cycle(sync0 ? cycle : 0);
  }
}

void Drive::on_state(AlState state) {
  if (was_op_ && state != AlState::kOp) leave_op();
  was_op_ = state == AlState::kOp;
  if (state == AlState::kSafeop) {
    choose_types();
    plain_inputs_ = shows_plain_inputs();
  }
  if (state == AlState::kOp) {
    integrator_ = 0;
    busy_until_ = 0;
    any_outputs_ = event_in_time_ = false;
    loop_.stop();
    event_due_.reset();
    waiting_.reset();
    arriving_.reset();
    arrived_.reset();
    if (!habits_.sync.counters.end_with_op) {
      outputs_sync_.clear_counters();
      inputs_sync_.clear_counters();
    }
  }
  if (state == AlState::kPreop || state == AlState::kInit) {
    last_sync_.reset();
    latch_due_.reset();
    clock_.release();
  }
}

/// Nothing that publish_inputs() does not look at, as far as the drive changes it by itself.
bool Drive::shows_plain_inputs() { return !inputs_map(SyncObject::kOutputs) && !inputs_map(SyncObject::kInputs); }

void Drive::leave_op() {
  run_servo(now());
  power_.disable();
  axis_.disable();
  if (habits_.sync.counters.end_with_op) {
    outputs_sync_.clear_counters();
    inputs_sync_.clear_counters();
  }
  publish_inputs();
}

void Drive::check_running(Nanoseconds time) {
  if (loop_.ended(time)) publish_inputs();
  run_servo(time);
  // The signal was there when OP was entered; a unit that was switched off or has lost its time fires no more.
  if (time >= sync_patience()) drop_to_safeop(al_code::kSyncStopped);
}

void Drive::on_resumed(Nanoseconds time) {
  if (last_sync_) last_sync_ = std::max(*last_sync_, time);
}

Nanoseconds Drive::sync_patience() const {
  const auto cycle = static_cast<Nanoseconds>(dc().settings().cycle0);
  return last_sync_ && cycle > 0 ? *last_sync_ + kMissingSyncs * cycle + 1 : INT64_MAX;
}

/// What the servo loop does between two SYNC0 is seen at the next one, unless the inputs are latched in between.
Nanoseconds Drive::runs_alone_until() {
  if (watched_ || !latches_at_sync0() || !last_sync_) return INT64_MIN;
  return latch_due_ ? *latch_due_ : sync_patience();
}

// ---- events --------------------------------------------------------------------------------------

const AxisCommand& Drive::command() {
  const bool sync0 = dc().sync0_enabled();
  if (!known_command_ || known_command_->outputs != outputs_taken() || known_command_->sync0 != sync0) {
    known_command_ = {read_command(sync0), outputs_taken(), sync0};
  }
  return known_command_->command;
}

AxisCommand Drive::read_command(bool sync0) {
  const auto& o = objects_;
  AxisCommand command;
  command.mode = axis_mode(o.mode.get());
  if (habits_.cyclic_modes_need_dc && is_cyclic(command.mode) && !sync0) command.mode = AxisMode::kNone;
  command.controlword = o.control.get();
  command.target_position = static_cast<std::int32_t>(o.target.get());
  command.target_velocity = static_cast<std::int32_t>(o.target_velocity.get());
  command.interpolation_point = static_cast<std::int32_t>(o.point.get());
  command.profile_velocity = o.profile_velocity.get();
  command.profile_acceleration = o.profile_acceleration.get();
  return command;
}

/// Time from one target to the next: the SYNC0 cycle, else what the master has written to 0x60C2.
Nanoseconds Drive::target_distance() {
  if (synchronised()) return dc().settings().cycle0;
  Nanoseconds time = objects_.interpolation_time.get() * kSecond;
  const auto index = static_cast<std::int8_t>(objects_.interpolation_index.get());
  for (int power = std::clamp<int>(index, -9, 0); power < 0; ++power) time /= 10;
  return time;
}

void Drive::on_outputs(Nanoseconds time) {
  run_servo(time);
  if (state() != AlState::kOp) return;
  any_outputs_ = true;
  take_arrived(time);
  const auto times = outputs_sync_.next_cycle(application_delay());
  if (synchronised()) {
    take_event(time);
    event_due_ = time + times.calc_and_copy - application_delay();
    if (arriving_) {
      waiting_ = times.calc_and_copy;  // it is still busy with those before
    } else {
      arriving_ = {command(), time + times.calc_and_copy};
    }
  } else {
    loop_.outputs_came(output_manager(), application_delay());
    if (loop_.begin(output_manager(), time, application_delay())) apply(command(), time);
  }
}

/// Outputs whose copying has ended by now are the application's.
void Drive::take_arrived(Nanoseconds time) {
  while (arriving_ && arriving_->ready <= time) {
    arrived_ = arriving_->command;
    const auto end = arriving_->ready;
    arriving_.reset();
    if (waiting_) arriving_ = {command(), end + *waiting_};
    waiting_.reset();
  }
}

/// An SM2 event that was early enough for the next SYNC0. Whether the firmware then gets ready in time is another
/// matter, that of exceeded cycles.
void Drive::take_event(Nanoseconds time) {
  if (!event_due_ || *event_due_ > time) return;
  event_in_time_ = true;
  event_due_.reset();
}

void Drive::on_sync0(Nanoseconds time) {
  run_servo(time);
  axis_.step(time);  // the inputs are those of this moment
  last_sync_ = time;
  (void)clock_.skip_before(time);
  if (!habits_.pll) {
    clock_.restart(time);
  } else {
    const auto cycle = dc().settings().cycle0;
    clock_.follow(time, cycle % habits_.servo_period_ns == 0 ? habits_.servo_period_ns : kCurrentLoop);
  }
  if (state() == AlState::kOp && synchronised()) {
    take_arrived(time);
    take_event(time);
    if (event_due_) outputs_sync_.count_shift_too_short();  // they came, but too late to be calculated with
    if (any_outputs_) count_sync_event(!event_in_time_);
    event_in_time_ = false;
    if (arrived_ && state() == AlState::kOp) apply(*arrived_, time);
    arrived_.reset();
  }
  begin_local_cycle(time);
  const auto shift = inputs_sync_.shift();
  if (inputs_sync_.type() != SyncType::kSync0) return;
  if (shift > 0) {
    latch_due_ = time + shift;
  } else {
    publish_inputs();
  }
}

void Drive::begin_local_cycle(Nanoseconds time) {
  const auto times = inputs_sync_.next_cycle(application_delay());
  if (state() == AlState::kOp && time < busy_until_) outputs_sync_.count_exceeded();
  busy_until_ = time + end_of(times);
}

void Drive::count_sync_event(bool missed) {
  if (missed) {
    outputs_sync_.count_missed();
    integrator_ += kMissWeight;
  } else if (integrator_ > 0) {
    --integrator_;
  }
  outputs_sync_.set_sync_error(missed);
  const auto limit = objects_.sync_error_limit.get();
  if (limit != 0 && integrator_ >= limit) raise_sync_alarm();
}

void Drive::raise_sync_alarm() {
  objects_.error_code.set(habits_.error_limit.error_code);
  power_.fault();
  drop_to_safeop(habits_.error_limit.al_status_code, habits_.error_limit.error_code);
}

// ---- servo loop ----------------------------------------------------------------------------------

void Drive::run_each_period(Nanoseconds time) {
  if (latch_due_ && *latch_due_ < time) {
    run_ticks(*latch_due_);
    axis_.step(*latch_due_);
    latch_due_.reset();
    publish_inputs();
  }
  run_ticks(time);
}

void Drive::run_ticks(Nanoseconds time) {
  bool any = false;
  if (passes_over_periods()) return;
  if (!axis_.enabled() && !watched_) {
    any = clock_.skip_before(time);
  } else {
    clock_.keep_last(kMostTicks, time);
    while (const auto tick = clock_.take_before(time)) {
      axis_.step(*tick);
      servo_tick(*tick);
      any = true;
    }
  }
  // Without a SYNC0 that says when, the inputs are those of the last servo period, unless the firmware is slow.
  if (any && !latches_at_sync0() && !loop_.under_way()) publish_inputs();
}

void Drive::apply(const AxisCommand& command, Nanoseconds time) {
  const auto state_before = power_.state();
  const bool was_enabled = power_.enabled();
  power_.control(command.controlword);
  steady_ = command == axis_.last_command() && power_.state() == state_before;
  if (power_.take_reset()) objects_.error_code.set(0);
  if (!power_.enabled()) axis_.disable();
  if (power_.enabled() && !was_enabled) axis_.enable(time);
  axis_.command(command, time, target_distance());
  objects_.mode_display.set(static_cast<std::uint8_t>(command.mode));
}

std::uint16_t Drive::statusword() {
  constexpr std::uint16_t kTargetReached = 0x0400, kModeSpecific = 0x1000;
  auto status = power_.statusword();
  if (!power_.enabled()) return status;
  const auto mode = static_cast<AxisMode>(objects_.mode_display.get());
  if (mode == AxisMode::kProfilePosition) {
    if (axis_.target_reached()) status |= kTargetReached;
    if (axis_.set_point_acknowledged()) status |= kModeSpecific;
  } else if (mode != AxisMode::kNone) {
    status |= kModeSpecific;  // follows the command value
  }
  return status;
}

void Drive::publish_inputs() {
  auto& o = objects_;
  const Published now{statusword(), o.error_code.get(), o.mode_display.get()};
  if (!axis_.take_moved() && published_ == now && plain_inputs_ && inputs_stay()) return renew_inputs();
  published_ = now;
  o.status.set(now.status);
  o.demand.set(static_cast<std::uint32_t>(axis_.demand_position()));
  o.actual.set(static_cast<std::uint32_t>(axis_.actual_position()));
  o.velocity.set(static_cast<std::uint32_t>(axis_.actual_velocity()));
  o.following_error.set(static_cast<std::uint32_t>(axis_.following_error()));
  inputs_from_dictionary();
}

}  // namespace syncline::sim
