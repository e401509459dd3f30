// SPDX-License-Identifier: Apache-2.0
#include "sim/al_checks.h"

#include <algorithm>

#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline::sim {

std::uint16_t AlChecks::mailbox() const {
  if (!config_.device.mailbox) return 0;
  for (unsigned i = 0; i < 2 && i < config_.device.sync_managers.size(); ++i) {
    const auto& wanted = config_.device.sync_managers[i];
    const auto sm = esc_.sync_manager(i);
    const bool size_fits = sm.length >= wanted.min_size.value_or(wanted.default_size.value_or(sm.length)) &&
                           sm.length <= wanted.max_size.value_or(wanted.default_size.value_or(sm.length));
    if (!sm.enabled() || !sm.is_mailbox() || sm.start != wanted.start_address || !size_fits) {
      return al_code::kInvalidMailbox;
    }
  }
  return 0;
}

std::uint16_t AlChecks::bootstrap() const {
  const std::span<const std::uint8_t> area(config_.device.eeprom.boot_strap);
  for (unsigned i = 0; i < 2; ++i) {
    const auto sm = esc_.sync_manager(i);
    if (!sm.enabled() || !sm.is_mailbox() || sm.start != load_le<std::uint16_t>(area.subspan(4 * i)) ||
        sm.length != load_le<std::uint16_t>(area.subspan(4 * i + 2))) {
      return al_code::kInvalidBootMailbox;
    }
  }
  return 0;
}

std::uint16_t AlChecks::safeop() const {
  const auto code = process_data();
  return code != 0 ? code : dc();
}

bool AlChecks::fits(PdoDirection direction) const {
  const auto bytes = process_data_.byte_length(direction);
  const auto number = process_data_.sync_manager(direction);
  if (!number) return bytes == 0;
  const auto sm = esc_.sync_manager(*number);
  return bytes == 0 ? !sm.enabled() || sm.length == 0 : sm.enabled() && sm.length == bytes;
}

bool AlChecks::in_place(PdoDirection direction) const {
  const auto number = process_data_.sync_manager(direction);
  if (!number) return true;
  const auto sm = esc_.sync_manager(*number);
  return !sm.enabled() || sm.length == 0 ||
         (sm.start == config_.device.sync_managers[*number].start_address && !sm.is_mailbox() &&
          sm.ecat_writes() == (direction == PdoDirection::kRx));
}

std::uint16_t AlChecks::process_data() const {
  if (!in_place(PdoDirection::kRx) || !in_place(PdoDirection::kTx)) return al_code::kInvalidSyncManager;
  if (!fits(PdoDirection::kRx)) return al_code::kInvalidOutputs;
  if (!fits(PdoDirection::kTx)) return al_code::kInvalidInputs;
  return 0;
}

std::uint16_t AlChecks::dc() const {
  const auto& dc = config_.device.dc;
  if (!dc || dc->op_modes.empty() || !esc_.dc().sync_active()) return 0;
  constexpr std::uint16_t kSignals = 0x0700;  // of AssignActivate: unit on, SYNC0, SYNC1
  const auto written = esc_.memory().u16(reg::kCyclicUnitControl);
  const bool known = std::ranges::any_of(
      dc->op_modes, [&](const DcOpMode& mode) { return ((mode.assign_activate ^ written) & kSignals) == 0; });
  return known ? 0 : al_code::kInvalidSyncConfiguration;
}

}  // namespace syncline::sim
