// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/drive_c.h"

#include <algorithm>
#include <string>

#include "families/families.h"
#include "protocol/registers.h"

namespace syncline::sim {
namespace {

constexpr Nanoseconds kServoPulse = 10 * kMicrosecond;
constexpr Nanoseconds kPulseUnit = 10;  // of register 0x0982

const families::Family& drive_c_family() {
  static const families::Family& found = *families::of_behaviour("drive-c");
  return found;
}

/// Entries are named as in the ESI of a Copley XE2.
DriveHabits drive_c_habits() {
  DriveHabits habits(drive_c_family(), SyncHabits::kFreeRun | SyncHabits::kSync0 | SyncHabits::kLocalShift);
  habits.pll = true;
  habits.sync.delay_name = "Hardware delay time";
  habits.sync.missed_name = "SM-Event missed";
  habits.sync.exceeded_name = "Cycle time too small";
  habits.sync.too_short_name = "Shift time too short";
  return habits;
}

}  // namespace

DriveC::DriveC(const SimSlaveConfig& config, Esc& esc) : Drive(config, esc, drive_c_habits()) {
  const auto& object = *drive_c_family().status;
  auto& status =
      dictionary_.add<std::uint16_t>(object.object.index, object.object.sub_index, std::string(object.name), 0);
  status.on_read = [this](ObjectDictionary::Entry& entry) { entry.value = le_bytes(synchronisation_status()); };
  pins_.resize(drive_c_family().pins->pins);
  add_pins();
}

void DriveC::add_pins() {
  auto& d = dictionary_;
  const auto& object = *drive_c_family().pins;
  d.set_object_name(object.index, "Output pin configuration");
  d.add<std::uint8_t>(object.index, 0, "Number of Entries", object.pins);
  for (std::uint8_t pin = 0; pin < object.pins; ++pin) {
    auto& entry =
        d.add(object.index, static_cast<std::uint8_t>(pin + 1), "Output " + std::to_string(pin) + " configuration",
              std::vector<std::uint8_t>(object.bytes), true);
    entry.on_write = [this, pin](std::span<const std::uint8_t> data) {
      return configure(pin, load_le<std::uint16_t>(data));
    };
  }
}

std::uint32_t DriveC::configure(std::size_t pin, std::uint16_t function) {
  const auto& functions = drive_c_family().pins->functions;
  if (std::ranges::find(functions, function, &families::PinFunction::value) == functions.end()) return abort::kRange;
  pins_[pin] = {function, {}};
  const auto shows = [this](std::uint16_t wanted) {
    return std::ranges::find(pins_, wanted, &Pin::function) != pins_.end();
  };
  watch_servo(shows(kServoPeriod));
  see_frames(shows(kFrame));
  return abort::kNone;
}

const PinTrace* DriveC::output_pin(unsigned number) const {
  return number >= 1 && number <= pins_.size() ? &pins_[number - 1].trace : nullptr;
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
  const auto& unit = dc();
  if (!unit.sync0_enabled()) return 0;
  const auto cycle = unit.settings().cycle0;
  const auto& limits = habits().cycle;
  std::uint16_t status = 0;
  if (cycle != 0 && cycle % limits.step == 0 && cycle <= limits.longest) status |= kLegal;
  if (cycle != 0 && cycle % limits.full_step == 0) {
    status |= kMultiple;
    if (status == (kLegal | kMultiple) && servo_clock().locked()) status |= kSynchronised;
  }
  if (unit.start_missed()) status |= kStartMissed;
  return status;
}

}  // namespace syncline::sim
