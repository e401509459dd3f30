// SPDX-License-Identifier: Apache-2.0
#include "compile/effective_slave.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/dc_description.h"
#include "config/device_description.h"
#include "config/module_slots.h"
#include "config/slave_options.h"
#include "config/slave_settings.h"
#include "config/sync0_cycle.h"

namespace syncline::compiler {
namespace {

constexpr std::uint8_t kWatchdogTrigger = 0x40;  // SyncManager control, bit 6
constexpr std::uint16_t kMaxFactor = 1000;       // far beyond what a frame can carry

bool has_oversampling(const SlaveSettings& slave) {
  if (!slave.oversampling.empty()) return true;
  const DcOpMode* mode = selected_op_mode(slave);
  return mode != nullptr &&
         std::ranges::any_of(mode->sync_managers, [](const auto& sm) { return !sm.oversampling.empty(); });
}

bool overrides_nothing(const SlaveSettings& slave) {
  return slave.modules.empty() && !has_oversampling(slave) && slave.watchdog == WatchdogSettings{} &&
         slave.timeouts == TimeoutSettings{} && !slave.mailbox.out_size && !slave.mailbox.in_size;
}

/// One sample of an oversampled PDO.
void append_sample(std::vector<PdoEntry>& out, const Pdo& pdo, std::uint16_t sample) {
  for (PdoEntry entry : pdo.entries) {
    if (entry.index != 0) {
      entry.index = static_cast<std::uint16_t>(entry.index + sample * pdo.os_index_increment.value_or(0));
      entry.name += fmt::format("[{}]", sample);
    }
    out.push_back(std::move(entry));
  }
}

void apply_oversampling(SlaveSettings& slave) {
  const auto apply = [&](std::vector<Pdo>& pdos) {
    for (Pdo& pdo : pdos) {
      const std::uint16_t factor = oversampling_factor(slave, pdo.index);
      if (factor <= 1) continue;
      std::vector<PdoEntry> samples;
      samples.reserve(pdo.entries.size() * factor);
      for (std::uint16_t sample = 0; sample < factor; ++sample) append_sample(samples, pdo, sample);
      pdo.entries = std::move(samples);
    }
  };
  apply(slave.device.rx_pdos);
  apply(slave.device.tx_pdos);
  apply(slave.changed_pdos);
}

template <class T>
void set_if(T& value, const std::optional<std::uint32_t>& wanted) {
  if (wanted) value = *wanted;
}

void apply_timeouts(DeviceDescription& device, const TimeoutSettings& user) {
  set_if(device.timeouts.preop, user.preop);
  set_if(device.timeouts.safeop_op, user.safeop_op);
  set_if(device.timeouts.back_to_init, user.back_to_init);
  set_if(device.timeouts.back_to_safeop, user.back_to_safeop);
  if (!device.mailbox) return;
  set_if(device.mailbox->request_timeout_ms, user.mailbox_request);
  set_if(device.mailbox->response_timeout_ms, user.mailbox_response);
}

void apply_watchdog(DeviceDescription& device, const WatchdogSettings& user) {
  if (user.divider) device.reg_0400 = user.divider;
  if (user.pdi) device.reg_0410 = user.pdi;
  if (user.process_data) device.reg_0420 = user.process_data;
  if (!user.outputs) return;
  for (auto& manager : device.sync_managers) {
    if (manager.type != SyncManagerType::kOutputs) continue;
    manager.control_byte = static_cast<std::uint8_t>(*user.outputs ? manager.control_byte | kWatchdogTrigger
                                                                   : manager.control_byte & ~kWatchdogTrigger);
  }
}

void apply_mailbox_sizes(DeviceDescription& device, const MailboxSettings& user) {
  for (auto& manager : device.sync_managers) {
    if (manager.type == SyncManagerType::kMailboxOut && user.out_size) manager.default_size = user.out_size;
    if (manager.type == SyncManagerType::kMailboxIn && user.in_size) manager.default_size = user.in_size;
  }
}

}  // namespace

std::uint16_t oversampling_factor(const SlaveSettings& slave, std::uint16_t pdo) {
  const auto bounded = [](std::uint16_t factor) { return std::clamp<std::uint16_t>(factor, 1, kMaxFactor); };
  const auto of_user = std::ranges::find(slave.oversampling, pdo, &PdoOversampling::pdo);
  if (of_user != slave.oversampling.end()) return bounded(of_user->factor);
  const DcOpMode* mode = selected_op_mode(slave);
  if (mode == nullptr) return 1;
  for (const OpModeSyncManager& manager : mode->sync_managers) {
    const auto of_mode = std::ranges::find(manager.oversampling, pdo, &PdoOversampling::pdo);
    if (of_mode != manager.oversampling.end()) return bounded(of_mode->factor);
  }
  return 1;
}

std::shared_ptr<const SlaveSettings> effective_slave(const SlaveSettings& slave) {
  if (overrides_nothing(slave)) return nullptr;
  auto effective = std::make_shared<SlaveSettings>(slave);
  if (!slave.modules.empty()) effective->device = device_with_modules(slave);
  if (has_oversampling(slave)) apply_oversampling(*effective);
  apply_timeouts(effective->device, slave.timeouts);
  apply_watchdog(effective->device, slave.watchdog);
  apply_mailbox_sizes(effective->device, slave.mailbox);
  return effective;
}

}  // namespace syncline::compiler
