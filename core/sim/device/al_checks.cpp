// SPDX-License-Identifier: Apache-2.0
#include "sim/device/al_checks.h"

#include <algorithm>

#include "config/dc_description.h"
#include "protocol/fmmu.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"
#include "sim/dc/dc_unit.h"
#include "sim/device/process_data.h"
#include "sim/registers/esc_memory.h"
#include "support/byte_order.h"

namespace syncline::sim {

std::uint16_t AlChecks::mailbox() const {
  if (!config_.device.mailbox) return 0;
  for (unsigned i = 0; i < 2 && i < config_.device.sync_managers.size(); ++i) {
    const auto& wanted = config_.device.sync_managers[i];
    const auto sm = esc_.sync_manager(i);
    const auto usual = wanted.default_size.value_or(sm.length);  // some ESI files give one outside of their own limits
    const bool size_fits = sm.length == usual || (sm.length >= wanted.min_size.value_or(usual) &&
                                                  sm.length <= wanted.max_size.value_or(usual));
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
  if (config_.device.mailbox && (set_up(0U) != mailbox_[0] || set_up(1U) != mailbox_[1])) return al_code::kNeedsInit;
  for (const auto check : {&AlChecks::process_data, &AlChecks::watchdog, &AlChecks::mapping, &AlChecks::dc}) {
    if (const auto code = (this->*check)(); code != 0) return code;
  }
  return 0;
}

std::uint16_t AlChecks::op() const {
  const bool same = set_up(PdoDirection::kRx) == data_[0] && set_up(PdoDirection::kTx) == data_[1];
  return same ? std::uint16_t{0} : al_code::kNeedsPreop;
}

AlChecks::SetUp AlChecks::set_up(unsigned number) const {
  const auto sm = esc_.sync_manager(number);
  return {sm.start, sm.length, sm.control, sm.enabled()};
}

std::vector<AlChecks::SetUp> AlChecks::set_up(PdoDirection direction) const {
  std::vector<SetUp> all;
  for (const unsigned number : process_data_.sync_managers(direction)) all.push_back(set_up(number));
  return all;
}

bool AlChecks::all(PdoDirection direction, Check check) const {
  return std::ranges::all_of(process_data_.sync_managers(direction),
                             [&](unsigned number) { return (this->*check)(direction, number); });
}

void AlChecks::note_mailbox() { mailbox_ = {set_up(0U), set_up(1U)}; }
void AlChecks::note_process_data() { data_ = {set_up(PdoDirection::kRx), set_up(PdoDirection::kTx)}; }

bool AlChecks::type_fits(PdoDirection, unsigned number) const {
  const auto sm = esc_.sync_manager(number);
  constexpr unsigned kMode = 0x03;
  return !sm.enabled() || sm.length == 0 ||
         ((sm.control ^ config_.device.sync_managers[number].control_byte) & kMode) == 0;
}

std::uint16_t AlChecks::watchdog() const {
  // Motion may not go on without its master. A description that switches the watchdog off means it.
  constexpr std::uint32_t kProfileMask = 0xFFFF, kDrives = 402;
  const auto& profiles = config_.device.profiles;
  const bool drive = !profiles.empty() && (profiles[0].profile_no & kProfileMask) == kDrives;
  const auto number = process_data_.sync_manager(PdoDirection::kRx);
  if (!drive || !number || config_.device.reg_0420 == 0) return 0;
  const bool watched = (esc_.sync_manager(*number).control & SyncManager::kControlWatchdog) != 0;
  return watched && esc_.memory().u16(reg::kWatchdogProcessData) == 0 ? al_code::kInvalidWatchdog : std::uint16_t{0};
}

bool AlChecks::mapping_fits(PdoDirection direction, unsigned number) const {
  const auto sm = esc_.sync_manager(number);
  if (!sm.enabled() || sm.length == 0) return true;
  const std::uint32_t begin = sm.start, end = begin + sm.length;
  const bool outputs = direction == PdoDirection::kRx;
  const bool buffered = !sm.is_mailbox() && begin >= EscMemory::kRegisterEnd;
  bool any = false, reached = false;
  for (unsigned i = 0; i < esc_.memory().u8(reg::kFmmuCount); ++i) {
    const auto fmmu = Fmmu::decode(esc_.memory().at(reg::fmmu(i), Fmmu::kSize).first<Fmmu::kSize>());
    if (!fmmu.active || fmmu.bit_length() == 0) continue;
    const std::uint32_t from = fmmu.physical_start;
    const std::uint32_t to = from + (fmmu.physical_start_bit + fmmu.bit_length() + 7) / 8;
    const bool touches = from < end && begin < to;
    if (touches && !outputs && fmmu.write && !fmmu.read) return false;
    if (!(outputs ? fmmu.write : fmmu.read)) continue;
    if (buffered && touches && to > end) return false;  // the buffers behind belong to the ESC
    any = any || from >= EscMemory::kRegisterEnd;       // the mailbox state and the like count for nothing
    reached = reached || touches;
  }
  return reached || !any;  // without any FMMU the master addresses the data directly
}

std::uint16_t AlChecks::mapping() const {
  if (!all(PdoDirection::kRx, &AlChecks::mapping_fits)) return al_code::kInvalidOutputMapping;
  return all(PdoDirection::kTx, &AlChecks::mapping_fits) ? std::uint16_t{0} : al_code::kInvalidInputMapping;
}

bool AlChecks::fits(PdoDirection, unsigned number) const {
  const auto bytes = process_data_.byte_length_of(number);
  const auto sm = esc_.sync_manager(number);
  return bytes == 0 ? !sm.enabled() || sm.length == 0 : sm.enabled() && sm.length == bytes;
}

bool AlChecks::in_place(PdoDirection direction, unsigned number) const {
  const auto sm = esc_.sync_manager(number);
  return !sm.enabled() || sm.length == 0 ||
         (sm.start == config_.device.sync_managers[number].start_address &&
          sm.ecat_writes() == (direction == PdoDirection::kRx));
}

std::uint16_t AlChecks::process_data() const {
  constexpr PdoDirection kOut = PdoDirection::kRx, kIn = PdoDirection::kTx;
  // Data for which the description has no SyncManager can never be exchanged.
  const auto homeless = [&](PdoDirection direction) {
    return process_data_.sync_managers(direction).empty() && process_data_.byte_length(direction) > 0;
  };
  if (!all(kOut, &AlChecks::in_place) || !all(kIn, &AlChecks::in_place)) return al_code::kInvalidSyncManager;
  if (!all(kOut, &AlChecks::type_fits) || !all(kIn, &AlChecks::type_fits)) return al_code::kInvalidTypes;
  if (homeless(kOut) || !all(kOut, &AlChecks::fits)) return al_code::kInvalidOutputs;
  if (homeless(kIn) || !all(kIn, &AlChecks::fits)) return al_code::kInvalidInputs;
  return 0;
}

std::uint16_t AlChecks::dc() const {
  const auto& dc = config_.device.dc;
  if (!dc || dc->op_modes.empty() || !esc_.dc().sync_active()) return 0;
  // Of AssignActivate: unit on, SYNC0, SYNC1; whose the latch inputs are.
  constexpr std::uint16_t kSignals = 0x0700, kLatches = 0x0030;
  const auto written = esc_.memory().u16(reg::kCyclicUnitControl);
  const auto fits = [&](std::uint16_t bits) {
    return std::ranges::any_of(dc->op_modes,
                               [&](const DcOpMode& mode) { return ((mode.assign_activate ^ written) & bits) == 0; });
  };
  if (!fits(kSignals)) return al_code::kInvalidSyncConfiguration;
  return fits(kSignals | kLatches) ? std::uint16_t{0} : al_code::kInvalidLatchConfiguration;
}

}  // namespace syncline::sim
