// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/drive_c.h"

namespace syncline::sim {
namespace {

constexpr std::uint32_t kCurrentLoop = 62'500, kServoLoop = 250'000, kLongest = 10'000'000;
constexpr DriveHabits kHabits{kCurrentLoop, kLongest, 0x0B, 4, 0xFFFF, 0x7380};

}  // namespace

DriveC::DriveC(const SimSlaveConfig& config, Esc& esc) : Drive(config, esc, kHabits) {
  auto& status = dictionary_.add<std::uint16_t>(0x21B4, 0, "Synchronisation status", 0);
  status.on_read = [this](ObjectDictionary::Entry& entry) { entry.value = le_bytes(synchronisation_status()); };
  dictionary_.add<std::uint8_t>(0x2193, 0, "Output pin configurations", 1);
  dictionary_.add<std::uint16_t>(0x2193, 1, "Output pin 1 configuration", 0, true);
}

void DriveC::on_state(AlState state) {
  Drive::on_state(state);
  if (state != AlState::kSafeop && state != AlState::kOp) return;
  dictionary_.set<std::uint16_t>(0x21B4, 0, synchronisation_status());
}

std::uint16_t DriveC::synchronisation_status() {
  std::uint16_t status = 0;
  const auto& dc = esc().dc();
  if (dc.sync0_enabled()) {
    const auto cycle = dc.settings().cycle0;
    const bool servo = cycle % kServoLoop == 0 && cycle <= kLongest;
    if (cycle % kCurrentLoop == 0) status |= 0x01;
    if (servo) status |= 0x06;
    if (dc.start_missed()) status |= 0x08;
  }
  return status;
}

}  // namespace syncline::sim
