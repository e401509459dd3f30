// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/drive_c.h"

#include <algorithm>

#include "protocol/registers.h"

namespace syncline::sim {
namespace {

constexpr std::uint32_t kCurrentLoop = 62'500, kServoLoop = 250'000, kLongest = 10'000'000;
constexpr std::uint16_t kPinFunctions = 0x2193, kStatus = 0x21B4;
constexpr Nanoseconds kServoPulse = 10 * kMicrosecond;
constexpr Nanoseconds kPulseUnit = 10;  // of register 0x0982

DriveHabits habits() {
  DriveHabits habits;
  habits.cycle_step_ns = kCurrentLoop;
  habits.cycle_max_ns = kLongest;
  habits.servo_period_ns = kServoLoop;
  habits.sync = {SyncHabits::kFreeRun | SyncHabits::kSync0 | SyncHabits::kMeasures, kCurrentLoop, 30'000, 5'000, 0x0B, 0x0C};
  habits.sync_error_limit = 4;
  habits.sync_error_limit_max = 0xFFFF;
  habits.sync_alarm = 0x7380;
  habits.sync_code = al_code::kSyncTimeout;  // this one says that it was SM2 events that did not come
  habits.type_follows_dc = false;
  habits.counters_end_with_op = false;
  habits.cyclic_modes_need_dc = false;
  habits.pll = true;
  return habits;
}

}  // namespace

DriveC::DriveC(const SimSlaveConfig& config, Esc& esc) : Drive(config, esc, sim::habits()) {
  auto& status = dictionary_.add<std::uint16_t>(kStatus, 0, "Network status", 0);
  status.on_read = [this](ObjectDictionary::Entry& entry) { entry.value = le_bytes(synchronisation_status()); };
  add_pins();
}

void DriveC::add_pins() {
  auto& d = dictionary_;
  d.set_object_name(kPinFunctions, "Output pin configurations");
  d.add<std::uint8_t>(kPinFunctions, 0, "Number of entries", kPins);
  for (std::size_t pin = 0; pin < kPins; ++pin) {
    auto& entry = d.add<std::uint16_t>(kPinFunctions, static_cast<std::uint8_t>(pin + 1), "Output pin configuration", kOff, true);
    entry.on_write = [this, pin](std::span<const std::uint8_t> data) { return configure(pin, load_le<std::uint16_t>(data)); };
  }
}

std::uint32_t DriveC::configure(std::size_t pin, std::uint16_t function) {
  if (function != kOff && function != kSync0 && function != kFrame && function != kServoPeriod) return abort::kRange;
  pins_[pin] = {function, {}};
  servo_pins_ = std::ranges::any_of(pins_, [](const Pin& p) { return p.function == kServoPeriod; });
  return abort::kNone;
}

const PinTrace* DriveC::output_pin(unsigned number) const {
  return number >= 1 && number <= kPins ? &pins_[number - 1].trace : nullptr;
}

void DriveC::pulse(Function function, Nanoseconds begin, Nanoseconds end) {
  for (auto& pin : pins_) {
    if (pin.function == function) pin.trace.pulse(begin, end);
  }
}

void DriveC::frame_received(Nanoseconds begin, Nanoseconds end) { pulse(kFrame, begin, end); }
void DriveC::servo_tick(Nanoseconds time) { pulse(kServoPeriod, time, time + kServoPulse); }

void DriveC::on_sync0(Nanoseconds time) {
  pulse(kSync0, time, time + kPulseUnit * esc().memory().u16(reg::kPulseLength));
  Drive::on_sync0(time);
}

std::uint16_t DriveC::synchronisation_status() {
  constexpr std::uint16_t kLegal = 0x01, kSynchronised = 0x02, kMultiple = 0x04, kStartMissed = 0x08;
  const auto& dc = esc().dc();
  if (!dc.sync0_enabled()) return 0;
  const auto cycle = dc.settings().cycle0;
  std::uint16_t status = 0;
  if (cycle != 0 && cycle % kCurrentLoop == 0 && cycle <= kLongest) status |= kLegal;
  if (cycle != 0 && cycle % kServoLoop == 0) {
    status |= kMultiple;
    if (status == (kLegal | kMultiple) && servo_clock().locked()) status |= kSynchronised;
  }
  if (dc.start_missed()) status |= kStartMissed;
  return status;
}

}  // namespace syncline::sim
