// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/drive.h"

#include <algorithm>

#include "protocol/registers.h"

namespace syncline::sim {
namespace {

constexpr std::uint16_t kSyncError = 0x001A, kSyncStopped = 0x002C, kNoSync = 0x002D, kPllError = 0x0032,
                        kInvalidSync0Cycle = 0x0036;
constexpr std::uint32_t kPllRange = 100'000;  // ns; the drive's PLL cannot lock on a clock that is further away
constexpr int kMissingSyncs = 8;
constexpr unsigned kMissWeight = 3;  // added for a missed event; a good one takes 1 away

// CiA 402 statusword patterns
constexpr std::uint16_t kSwitchOnDisabled = 0x0250, kReadyToSwitchOn = 0x0231, kSwitchedOn = 0x0233,
                        kOperationEnabled = 0x1237, kFault = 0x0218;

}  // namespace

Drive::Drive(const SimSlaveConfig& config, Esc& esc, const DriveHabits& habits) : Device(config, esc), habits_(habits) {
  add_objects();
  enable_diagnosis_history();
}

void Drive::add_objects() {
  auto& d = dictionary_;
  d.add<std::uint16_t>(0x603F, 0, "Error code", 0);
  d.add<std::uint16_t>(0x6040, 0, "Controlword", 0, true);
  d.add<std::uint16_t>(0x6041, 0, "Statusword", kSwitchOnDisabled);
  d.add<std::uint8_t>(0x6060, 0, "Modes of operation", 8, true);
  d.add<std::uint8_t>(0x6061, 0, "Modes of operation display", 8);
  d.add<std::uint32_t>(0x6064, 0, "Position actual value", 0);
  d.add<std::uint32_t>(0x607A, 0, "Target position", 0, true);
  d.add<std::uint32_t>(0x60F4, 0, "Following error actual value", 0);
  d.add<std::uint8_t>(0x60C2, 0, "Interpolation time period", 2);
  d.add<std::uint8_t>(0x60C2, 1, "Interpolation time period value", 1, true);
  d.add<std::uint8_t>(0x60C2, 2, "Interpolation time index", 0xFD, true);
  d.add<std::uint8_t>(0x10F1, 0, "Error settings", 2);
  d.add<std::uint32_t>(0x10F1, 1, "Local error reaction", 1, true);
  auto& limit = d.add<std::uint16_t>(0x10F1, 2, "Sync error counter limit", habits_.sync_error_limit, true);
  limit.on_write = [this](std::span<const std::uint8_t> data) {
    return load_le<std::uint16_t>(data) <= habits_.sync_error_limit_max ? abort::kNone : abort::kRange;
  };
  const std::uint8_t missed = habits_.sm_missed_sub_index;
  const std::uint8_t exceeded = missed == 0x0B ? 0x0C : 0x0B;
  for (const std::uint16_t index : {std::uint16_t{0x1C32}, std::uint16_t{0x1C33}}) {
    d.add<std::uint8_t>(index, 0x00, index == 0x1C32 ? "SM output parameter" : "SM input parameter", 0x20);
    auto& type = d.add<std::uint16_t>(index, 0x01, "Synchronization type", 0, true);
    type.preop_only = true;
    d.add<std::uint32_t>(index, 0x02, "Cycle time", 0, true);
    d.add<std::uint32_t>(index, 0x03, "Shift time", 0);
    d.add<std::uint16_t>(index, 0x04, "Synchronization types supported", 0x0007);
    d.add<std::uint32_t>(index, 0x05, "Minimum cycle time", habits_.cycle_step_ns);
    d.add<std::uint32_t>(index, 0x06, "Calc and copy time", 62'500);
    d.add<std::uint32_t>(index, 0x09, "Delay time", 0);
    d.add<std::uint16_t>(index, missed, "SM event missed counter", 0);
    d.add<std::uint16_t>(index, exceeded, "Cycle exceeded counter", 0);
    d.add<std::uint8_t>(index, 0x20, "Sync error", 0);
  }
}

std::uint16_t Drive::check_sync(AlState to) {
  const auto& dc = esc().dc();
  if (!dc.sync_active()) return 0;
  const auto cycle = dc.settings().cycle0;
  if (cycle == 0 || cycle % habits_.cycle_step_ns != 0 || cycle > habits_.cycle_max_ns) return kInvalidSync0Cycle;
  // OP needs a SYNC0 that comes: a start time in the past never fires.
  if (to == AlState::kOp && !last_sync_) return kNoSync;
  if (to == AlState::kOp && dc.deviation_magnitude() > kPllRange) return kPllError;
  return 0;
}

void Drive::check_running(Nanoseconds time) {
  const auto& dc = esc().dc();
  // The signal was there when OP was entered; a unit that was switched off or has lost its time fires no more.
  const auto cycle = static_cast<Nanoseconds>(dc.settings().cycle0);
  if (last_sync_ && cycle > 0 && time - *last_sync_ > kMissingSyncs * cycle) drop_to_safeop(kSyncStopped);
}

void Drive::on_state(AlState state) {
  if (state == AlState::kSafeop) {
    const bool synchronous = esc().dc().sync0_enabled();
    for (const std::uint16_t index : {std::uint16_t{0x1C32}, std::uint16_t{0x1C33}}) {
      dictionary_.set<std::uint16_t>(index, 0x01, synchronous ? 2 : (index == 0x1C32 ? 1 : 0x22));
      if (synchronous) dictionary_.set<std::uint32_t>(index, 0x02, esc().dc().settings().cycle0);
    }
  }
  if (state == AlState::kOp) {
    integrator_ = 0;
    any_outputs_ = outputs_since_sync_ = false;
    dictionary_.set<std::uint16_t>(0x1C32, habits_.sm_missed_sub_index, 0);
    dictionary_.set<std::uint16_t>(0x603F, 0, 0);
  }
  if (state == AlState::kPreop || state == AlState::kInit) last_sync_.reset();
}

void Drive::on_outputs(Nanoseconds time) {
  outputs_since_sync_ = any_outputs_ = true;
  if (!esc().dc().sync0_enabled()) {  // synchronous with the SM2 event
    move();
    servo_cycle(time);
    inputs_from_dictionary();
  }
}

void Drive::on_sync0(Nanoseconds time) {
  last_sync_ = time;
  if (state() == AlState::kOp && any_outputs_) count_sync_event();
  outputs_since_sync_ = false;
  move();
  servo_cycle(time);
  inputs_from_dictionary();
}

void Drive::count_sync_event() {
  const bool missed = !outputs_since_sync_;
  if (missed) {
    const auto count = dictionary_.get<std::uint16_t>(0x1C32, habits_.sm_missed_sub_index);
    dictionary_.set<std::uint16_t>(0x1C32, habits_.sm_missed_sub_index, static_cast<std::uint16_t>(count + 1));
    integrator_ += kMissWeight;
  } else if (integrator_ > 0) {
    --integrator_;
  }
  dictionary_.set<std::uint8_t>(0x1C32, 0x20, missed ? 1 : 0);
  const auto limit = dictionary_.get<std::uint16_t>(0x10F1, 2);
  if (limit == 0 || integrator_ < limit) return;
  dictionary_.set<std::uint16_t>(0x603F, 0, habits_.sync_alarm);
  dictionary_.set<std::uint16_t>(0x6041, 0, kFault);
  drop_to_safeop(kSyncError, habits_.sync_alarm);
}

void Drive::power_state_machine() {
  if (dictionary_.get<std::uint16_t>(0x603F, 0) != 0) return;
  const auto control = dictionary_.get<std::uint16_t>(0x6040, 0) & 0x0FU;
  std::uint16_t status = kSwitchOnDisabled;
  if (control == 0x06) status = kReadyToSwitchOn;
  if (control == 0x07) status = kSwitchedOn;
  if (control == 0x0F) status = kOperationEnabled;
  dictionary_.set<std::uint16_t>(0x6041, 0, status);
}

void Drive::move() {
  power_state_machine();
  dictionary_.set<std::uint8_t>(0x6061, 0, dictionary_.get<std::uint8_t>(0x6060, 0));
  const auto target = dictionary_.get<std::uint32_t>(0x607A, 0);
  if (dictionary_.get<std::uint16_t>(0x6041, 0) != kOperationEnabled) return;
  const auto actual = dictionary_.get<std::uint32_t>(0x6064, 0);
  dictionary_.set<std::uint32_t>(0x60F4, 0, target - actual);
  dictionary_.set<std::uint32_t>(0x6064, 0, target);
}

}  // namespace syncline::sim
